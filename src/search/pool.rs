//! One search on several threads.
//!
//! Every thread walks a path of its own in slices. A thread that runs dry says so; another then
//! gives it the later half of its shallowest alternatives. Counts are sums over disjoint parts
//! of one tree, so they do not depend on the number of threads. Nor does the first solution:
//! parts are intervals of the undivided walk, so once a part has found a solution, the parts
//! after it are dropped, those before it go on, and only what lies before the solution finally
//! kept is counted.

use super::state::is_before;
use super::{Alternatives, Best, Limits, Part, Path, Problem, Progress, Record, Sink, Slice};
use super::{State, Values, Walk};
use crossbeam::channel::{RecvTimeoutError, bounded};
use crossbeam::deque::{Injector, Steal};
use std::sync::atomic::{AtomicBool, AtomicU64, AtomicUsize, Ordering::SeqCst};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

/// The most nodes between two looks.
const LONGEST_SLICE: u64 = 1 << 17;
/// The time that slices are made to take at most, so that a search that is to stop, stops soon.
const SLICE_TIME: Duration = Duration::from_millis(2);
/// Time between two looks at the limits and two reports of progress.
const TICK: Duration = Duration::from_millis(50);
/// Time an idle thread sleeps between two looks for work.
const NAP: Duration = Duration::from_micros(50);

/// What to search, and how.
pub struct Plan<'a, P: Problem> {
    /// The problem, without choices.
    pub problem: P,
    /// Copies of it for threads to work on, made when needed and kept from one run to the next:
    /// the tables of a large problem take longer to copy than a search may pause.
    pub copies: Vec<P>,
    /// The order of alternatives.
    pub values: Values,
    /// The part of the tree to which the paths belong, if it is divided.
    pub part: Option<Part>,
    /// The number of threads, at least 1.
    pub threads: usize,
    /// When to stop early.
    pub limits: Limits<'a>,
    /// Called on the calling thread some twenty times a second.
    pub watch: &'a dyn Fn(&Progress),
}

impl<P: Problem> Plan<'_, P> {
    /// One thread, without limits or reports.
    pub fn simple(problem: P, values: Values) -> Self {
        Self {
            problem,
            copies: Vec::new(),
            part: None,
            values,
            threads: 1,
            limits: Limits::NONE,
            watch: &|_| {},
        }
    }
}

/// How much of the tree is still to visit (Knuth's measure): of the paths in the queue, and of
/// the path of each thread when last measured.
struct Remaining {
    queued: f64,
    walked: Vec<f64>,
}

struct Shared<A, F> {
    /// Paths to walk, with what remains on them.
    queue: Injector<(Path<A>, f64)>,
    /// Paths queued or walked; at 0 all is done.
    pending: AtomicUsize,
    /// Threads without work.
    hungry: AtomicUsize,
    stop: AtomicBool,
    /// Nodes that may still be visited.
    budget: AtomicU64,
    nodes: AtomicU64,
    solutions: AtomicU64,
    deepest: AtomicUsize,
    /// Rises whenever threads are to measure what remains.
    tick: AtomicUsize,
    remaining: Mutex<Remaining>,
    best: Mutex<Option<Best<F>>>,
    /// How often `best` has changed, to be read without its lock.
    found: AtomicUsize,
    left: Mutex<Vec<Path<A>>>,
    /// Kept only when a sink may break off.
    records: Mutex<Vec<Record>>,
}

/// Searches on from `state`; `sink` makes the sink of each thread. Gives what the search then
/// stands at, and the sinks of all threads joined.
///
/// # Panics
/// Only if the problem or the sink does; the panic of any thread is passed on.
pub fn run<P, S>(
    plan: &mut Plan<'_, P>,
    state: State<Path<P::Alternatives>, S::Found>,
    sink: impl Fn() -> S,
) -> (State<Path<P::Alternatives>, S::Found>, S)
where
    P: Problem,
    S: Sink<P>,
{
    let begin = Instant::now();
    let threads = plan.threads.max(1);
    let before = state.elapsed;
    let shared = Shared::new(plan, state, threads);
    let mut copies = std::mem::take(&mut plan.copies).into_iter();
    let levels = plan.problem.levels();
    let (done, finished) = bounded::<()>(0);
    let (mut joined, mut kept) = (sink(), Vec::with_capacity(threads));
    std::thread::scope(|scope| {
        let mut handles = Vec::with_capacity(threads);
        for id in 0..threads {
            let (shared, values, part) = (&shared, plan.values, plan.part);
            let worker =
                Worker { id, shared, values, part, slice: P::FIRST_SLICE, tick: 0, found: 0 };
            let (problem, copy) = (&plan.problem, copies.next());
            let (sink, done) = (sink(), done.clone());
            handles.push(scope.spawn(move || {
                let _guard = StopOnPanic(&shared.stop);
                // Dropped at the end, also by a panic: that wakes the caller.
                let _done = done;
                // Cloned by the thread itself, so that its memory is not shared with others'.
                worker.work(copy.unwrap_or_else(|| problem.clone()), sink)
            }));
        }
        drop(done);
        // The scope waits for all threads, also when a stop or a report panics.
        let _guard = StopOnPanic(&shared.stop);
        let mut fraction = 0.0f64;
        while let Err(RecvTimeoutError::Timeout) = finished.recv_timeout(TICK) {
            if plan.limits.stop.should_stop() {
                shared.stop.store(true, SeqCst);
            }
            fraction = fraction.max(1.0 - lock(&shared.remaining).sum());
            shared.tick.fetch_add(1, SeqCst);
            (plan.watch)(&Progress {
                nodes: shared.nodes.load(SeqCst),
                solutions: shared.solutions.load(SeqCst),
                deepest: shared.deepest.load(SeqCst),
                levels,
                fraction,
                elapsed: before + begin.elapsed(),
            });
        }
        for handle in handles {
            match handle.join() {
                Ok((copy, sink)) => {
                    kept.push(copy);
                    joined.join(sink);
                }
                Err(panic) => std::panic::resume_unwind(panic),
            }
        }
    });
    plan.copies = kept;
    (shared.state(plan.values, before + begin.elapsed()), joined)
}

/// Lets the other threads end when this one panics.
struct StopOnPanic<'a>(&'a AtomicBool);

impl Drop for StopOnPanic<'_> {
    fn drop(&mut self) {
        if std::thread::panicking() {
            self.0.store(true, SeqCst);
        }
    }
}

struct Worker<'a, A, F> {
    id: usize,
    shared: &'a Shared<A, F>,
    values: Values,
    part: Option<Part>,
    /// Nodes of its next slice.
    slice: u64,
    /// The tick for which it last measured what remains.
    tick: usize,
    /// How many changes of the best solution it has seen in this part.
    found: usize,
}

impl<A: Alternatives, F: Send> Worker<'_, A, F> {
    /// Walks parts until none is left or the search stops; gives the problem back without choices.
    fn work<P, S>(mut self, mut problem: P, mut sink: S) -> (P, S)
    where
        P: Problem<Alternatives = A>,
        S: Sink<P, Found = F>,
    {
        let shared = self.shared;
        let root = Path::root(&mut problem);
        let mut walk = Walk::new(problem, self.values, root).within(self.part);
        while let Some((path, remaining)) = self.next_path() {
            lock(&shared.remaining).take(self.id, remaining);
            self.found = 0;
            let start = path.start(self.values);
            if !self.is_too_late(&start) {
                (walk.nodes, walk.solutions, walk.deepest) = (0, 0, path.level());
                walk.change(path);
                self.walk_part(&mut walk, &mut sink, &start);
                if sink.breaks() {
                    let (nodes, solutions, deepest) = (walk.nodes, walk.solutions, walk.deepest);
                    lock(&shared.records).push(Record { start, nodes, solutions, deepest });
                }
            }
            // What a stop leaves behind has not been visited.
            if !shared.stop.load(SeqCst) {
                lock(&shared.remaining).walked[self.id] = 0.0;
            }
            shared.pending.fetch_sub(1, SeqCst);
        }
        (walk.into_problem(), sink)
    }

    /// Waits for a path; `None` when the search is over.
    fn next_path(&self) -> Option<(Path<A>, f64)> {
        let mut hungry = false;
        let path = loop {
            if self.shared.stop.load(SeqCst) {
                break None;
            }
            match self.shared.queue.steal() {
                Steal::Success(path) => break Some(path),
                Steal::Retry => continue,
                Steal::Empty if self.shared.pending.load(SeqCst) == 0 => break None,
                Steal::Empty => {}
            }
            if !hungry {
                self.shared.hungry.fetch_add(1, SeqCst);
                hungry = true;
            }
            std::thread::sleep(NAP);
        };
        if hungry {
            self.shared.hungry.fetch_sub(1, SeqCst);
        }
        path
    }

    fn walk_part<P, S>(&mut self, walk: &mut Walk<P>, sink: &mut S, start: &[u32])
    where
        P: Problem<Alternatives = A>,
        S: Sink<P, Found = F>,
    {
        let shared = self.shared;
        loop {
            let budget = shared.claim(self.slice);
            if budget == 0 || shared.stop.load(SeqCst) {
                shared.budget.fetch_add(budget, SeqCst);
                shared.stop.store(true, SeqCst);
                return lock(&shared.left).push(walk.path().clone());
            }
            let (nodes, solutions) = (walk.nodes, walk.solutions);
            let begin = Instant::now();
            let slice = walk.run(budget, sink);
            self.slice = match begin.elapsed() {
                time if time > SLICE_TIME => (self.slice / 2).max(1),
                time if time < SLICE_TIME / 4 => (self.slice * 2).min(LONGEST_SLICE),
                _ => self.slice,
            };
            let spent = walk.nodes - nodes;
            shared.budget.fetch_add(budget - spent, SeqCst);
            shared.nodes.fetch_add(spent, SeqCst);
            shared.solutions.fetch_add(walk.solutions - solutions, SeqCst);
            shared.deepest.fetch_max(walk.deepest, SeqCst);
            match slice {
                Slice::Paused => {}
                Slice::Exhausted => return,
                Slice::Found(found) => return shared.offer(walk.solution(), found, self.values),
            }
            if self.is_too_late(start) {
                return;
            }
            self.share(walk);
        }
    }

    /// Whether a solution is known that comes before all of the part that begins at `start`.
    /// Parts are intervals of the walk and end at their first solution, so no other part can
    /// hold solutions on both sides of it.
    fn is_too_late(&mut self, start: &[u32]) -> bool {
        let found = self.shared.found.load(SeqCst);
        if found == self.found {
            return false;
        }
        self.found = found;
        let best = lock(&self.shared.best);
        best.as_ref().is_some_and(|best| is_before(self.values, &best.choices, start))
    }

    /// Feeds a hungry thread, and measures what remains when asked to.
    fn share<P: Problem<Alternatives = A>>(&mut self, walk: &mut Walk<P>) {
        let shared = self.shared;
        let tick = shared.tick.load(SeqCst);
        let hungry = shared.hungry.load(SeqCst) > shared.queue.len();
        if tick == self.tick && !hungry {
            return;
        }
        self.tick = tick;
        let whole = walk.remaining();
        let Some(path) = hungry.then(|| walk.split()).flatten() else {
            lock(&shared.remaining).walked[self.id] = whole;
            return;
        };
        let kept = walk.remaining();
        {
            let mut remaining = lock(&shared.remaining);
            remaining.walked[self.id] = kept;
            remaining.queued += whole - kept;
        }
        shared.pending.fetch_add(1, SeqCst);
        shared.queue.push((path, whole - kept));
    }
}

impl Remaining {
    fn sum(&self) -> f64 {
        self.queued + self.walked.iter().sum::<f64>()
    }

    fn take(&mut self, id: usize, remaining: f64) {
        self.queued -= remaining;
        self.walked[id] = remaining;
    }
}

impl<A: Alternatives, F> Shared<A, F> {
    fn new<P>(plan: &mut Plan<'_, P>, state: State<Path<A>, F>, threads: usize) -> Self
    where
        P: Problem<Alternatives = A>,
    {
        let queue = Injector::new();
        let (pending, mut queued) = (state.left.len(), 0.0);
        let part = plan.part.map(|part| part.within(plan.problem.levels()));
        for path in state.left {
            path.replay(&mut plan.problem);
            let remaining = path.remaining(&mut plan.problem, part);
            path.rewind(&mut plan.problem);
            queued += remaining;
            queue.push((path, remaining));
        }
        Self {
            queue,
            pending: AtomicUsize::new(pending),
            hungry: AtomicUsize::new(0),
            stop: AtomicBool::new(false),
            budget: AtomicU64::new(plan.limits.nodes),
            nodes: AtomicU64::new(state.nodes),
            solutions: AtomicU64::new(state.solutions),
            deepest: AtomicUsize::new(state.deepest),
            tick: AtomicUsize::new(0),
            remaining: Mutex::new(Remaining { queued, walked: vec![0.0; threads] }),
            found: AtomicUsize::new(usize::from(state.best.is_some())),
            best: Mutex::new(state.best),
            left: Mutex::new(Vec::new()),
            records: Mutex::new(state.records),
        }
    }

    /// Takes the nodes of one slice from the budget; 0 when it is used up.
    fn claim(&self, slice: u64) -> u64 {
        let take = |left: u64| Some(left - left.min(slice));
        self.budget.fetch_update(SeqCst, SeqCst, take).unwrap_or(0).min(slice)
    }

    /// Keeps a solution if it is the first so far.
    fn offer(&self, choices: &[u32], found: F, values: Values) {
        let mut best = lock(&self.best);
        if best.as_ref().is_none_or(|best| is_before(values, choices, &best.choices)) {
            *best = Some(Best { choices: choices.to_vec(), found });
            self.found.fetch_add(1, SeqCst);
        }
    }

    /// What the search stands at after `elapsed`.
    fn state(self, values: Values, elapsed: Duration) -> State<Path<A>, F> {
        let mut left = into_inner(self.left);
        while let Steal::Success((path, _)) = self.queue.steal() {
            left.push(path);
        }
        let mut state = State {
            left,
            nodes: self.nodes.into_inner(),
            solutions: self.solutions.into_inner(),
            deepest: self.deepest.into_inner(),
            best: into_inner(self.best),
            records: into_inner(self.records),
            elapsed,
        };
        state.tidy(values);
        state
    }
}

/// Locks even after a panic of another thread, which is passed on at the end anyway.
fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

fn into_inner<T>(mutex: Mutex<T>) -> T {
    mutex.into_inner().unwrap_or_else(PoisonError::into_inner)
}
