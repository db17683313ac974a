//! One search on several threads.
//!
//! Every thread walks a path of its own in slices. A thread that runs dry says so; another then
//! gives it the later half of its shallowest alternatives. Counts are sums over disjoint parts
//! of one tree, so they do not depend on the number of threads. Nor does the first solution:
//! parts are intervals of the undivided walk, so once a part has found a solution, the parts
//! after it are dropped, those before it go on, and only what lies before the solution finally
//! kept is counted.

use super::{Alternatives, Limits, Path, Problem, Progress, Sink, Slice, Values, Walk};
use crossbeam::channel::{RecvTimeoutError, bounded};
use crossbeam::deque::{Injector, Steal};
use std::sync::atomic::{AtomicBool, AtomicU64, AtomicUsize, Ordering::SeqCst};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

/// Nodes between two looks at the other threads: well under a millisecond of work.
const SLICE: u64 = 1 << 14;
/// Time between two looks at the limits and two reports of progress.
const TICK: Duration = Duration::from_millis(50);
/// Time an idle thread sleeps between two looks for work.
const NAP: Duration = Duration::from_micros(50);

/// What to search, and how.
pub struct Plan<'a, P: Problem> {
    /// The problem, without choices.
    pub problem: P,
    /// The order of alternatives.
    pub values: Values,
    /// What to visit: the root, or what an earlier search left.
    pub paths: Vec<Path<P::Alternatives>>,
    /// The number of threads, at least 1.
    pub threads: usize,
    /// When to stop early.
    pub limits: Limits<'a>,
    /// Called on the calling thread some twenty times a second.
    pub watch: &'a dyn Fn(&Progress),
}

impl<P: Problem> Plan<'_, P> {
    /// The whole tree of `problem`, on one thread, without limits or reports.
    pub fn whole(mut problem: P, values: Values) -> Self {
        let paths = vec![Path::root(&mut problem)];
        Self { problem, values, paths, threads: 1, limits: Limits::NONE, watch: &|_| {} }
    }
}

/// What a search came to.
#[derive(Debug, Clone)]
pub struct Outcome<A, S, F> {
    /// Whether the answer is final: everything was visited, or the first solution found and
    /// everything before it visited.
    pub complete: bool,
    /// The first solution at which the sink broke off; when not `complete`, the first known.
    pub found: Option<F>,
    /// Nodes visited (when complete: up to the solution found, whatever other threads did).
    pub nodes: u64,
    /// Solutions met.
    pub solutions: u64,
    /// The largest number of choices made at once.
    pub deepest: usize,
    /// What is left to visit: empty when complete.
    pub left: Vec<Path<A>>,
    /// The sinks of all threads joined.
    pub sink: S,
}

/// What a part of the search did, and where it began.
struct Part {
    start: Vec<u32>,
    nodes: u64,
    solutions: u64,
    deepest: usize,
}

/// The first solution so far.
struct Best<F> {
    choices: Vec<u32>,
    found: F,
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
    parts: Mutex<Vec<Part>>,
}

/// Searches; `sink` makes the sink of each thread.
///
/// # Panics
/// Only if the problem or the sink does; the panic of any thread is passed on.
pub fn run<P, S>(plan: Plan<'_, P>, sink: impl Fn() -> S) -> Outcome<P::Alternatives, S, S::Found>
where
    P: Problem,
    S: Sink<P>,
{
    let begin = Instant::now();
    let threads = plan.threads.max(1);
    let shared = Shared::new(&plan, threads);
    let levels = plan.problem.levels();
    let (done, finished) = bounded::<()>(0);
    let mut joined = sink();
    std::thread::scope(|scope| {
        let mut handles = Vec::with_capacity(threads);
        for id in 0..threads {
            let worker = Worker { id, shared: &shared, values: plan.values, tick: 0, found: 0 };
            let (problem, sink, done) = (&plan.problem, sink(), done.clone());
            handles.push(scope.spawn(move || {
                let _guard = StopOnPanic(&worker.shared.stop);
                // Dropped at the end, also by a panic: that wakes the caller.
                let _done = done;
                // Cloned by the thread itself, so that its memory is not shared with others'.
                worker.work(problem.clone(), sink)
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
                elapsed: begin.elapsed(),
            });
        }
        for handle in handles {
            match handle.join() {
                Ok(sink) => joined.join(sink),
                Err(panic) => std::panic::resume_unwind(panic),
            }
        }
    });
    shared.outcome(plan.values, joined)
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
    /// The tick for which it last measured what remains.
    tick: usize,
    /// How many changes of the best solution it has seen in this part.
    found: usize,
}

impl<A: Alternatives, F: Send> Worker<'_, A, F> {
    /// Walks parts until none is left or the search stops.
    fn work<P, S>(mut self, mut problem: P, mut sink: S) -> S
    where
        P: Problem<Alternatives = A>,
        S: Sink<P, Found = F>,
    {
        let shared = self.shared;
        let root = Path::root(&mut problem);
        let mut walk = Walk::new(problem, self.values, root);
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
                    lock(&shared.parts).push(Part { start, nodes, solutions, deepest });
                }
            }
            // What a stop leaves behind has not been visited.
            if !shared.stop.load(SeqCst) {
                lock(&shared.remaining).walked[self.id] = 0.0;
            }
            shared.pending.fetch_sub(1, SeqCst);
        }
        sink
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
            let budget = shared.claim();
            if budget == 0 || shared.stop.load(SeqCst) {
                shared.budget.fetch_add(budget, SeqCst);
                shared.stop.store(true, SeqCst);
                return lock(&shared.left).push(walk.path().clone());
            }
            let (nodes, solutions) = (walk.nodes, walk.solutions);
            let slice = walk.run(budget, sink);
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
    fn new<P>(plan: &Plan<'_, P>, threads: usize) -> Self
    where
        P: Problem<Alternatives = A>,
    {
        let queue = Injector::new();
        let mut queued = 0.0;
        for path in &plan.paths {
            let (problem, values) = (plan.problem.clone(), plan.values);
            let remaining = Walk::new(problem, values, path.clone()).remaining();
            queued += remaining;
            queue.push((path.clone(), remaining));
        }
        Self {
            queue,
            pending: AtomicUsize::new(plan.paths.len()),
            hungry: AtomicUsize::new(0),
            stop: AtomicBool::new(false),
            budget: AtomicU64::new(plan.limits.nodes),
            nodes: AtomicU64::new(0),
            solutions: AtomicU64::new(0),
            deepest: AtomicUsize::new(0),
            tick: AtomicUsize::new(0),
            remaining: Mutex::new(Remaining { queued, walked: vec![0.0; threads] }),
            best: Mutex::new(None),
            found: AtomicUsize::new(0),
            left: Mutex::new(Vec::new()),
            parts: Mutex::new(Vec::new()),
        }
    }

    /// Takes nodes for one slice from the budget; 0 when it is used up.
    fn claim(&self) -> u64 {
        let take = |left: u64| Some(left - left.min(SLICE));
        self.budget.fetch_update(SeqCst, SeqCst, take).unwrap_or(0).min(SLICE)
    }

    /// Keeps a solution if it is the first so far.
    fn offer(&self, choices: &[u32], found: F, values: Values) {
        let mut best = lock(&self.best);
        if best.as_ref().is_none_or(|best| is_before(values, choices, &best.choices)) {
            *best = Some(Best { choices: choices.to_vec(), found });
            self.found.fetch_add(1, SeqCst);
        }
    }

    fn outcome<S>(self, values: Values, sink: S) -> Outcome<A, S, F> {
        let mut left = into_inner(self.left);
        while let Steal::Success((path, _)) = self.queue.steal() {
            left.push(path);
        }
        left.retain(|path| !path.is_exhausted());
        let mut outcome = Outcome {
            complete: left.is_empty(),
            found: None,
            nodes: self.nodes.into_inner(),
            solutions: self.solutions.into_inner(),
            deepest: self.deepest.into_inner(),
            left,
            sink,
        };
        if let Some(best) = into_inner(self.best) {
            let counts = |start: &[u32]| !is_before(values, &best.choices, start);
            outcome.left.retain(|path| counts(&path.start(values)));
            outcome.complete = outcome.left.is_empty();
            if outcome.complete {
                let parts = into_inner(self.parts);
                let parts = || parts.iter().filter(|part| counts(&part.start));
                outcome.nodes = parts().map(|part| part.nodes).sum();
                outcome.solutions = parts().map(|part| part.solutions).sum();
                outcome.deepest = parts().map(|part| part.deepest).max().unwrap_or(0);
            }
            outcome.found = Some(best.found);
        }
        outcome
    }
}

/// Whether the choices `a` come before the choices `b` in the walk; where one continues the
/// other they do not come before each other.
fn is_before(values: Values, a: &[u32], b: &[u32]) -> bool {
    let differ = a.iter().zip(b).enumerate().find(|(_, (a, b))| a != b);
    differ.is_some_and(|(level, (&a, &b))| values.before(level, a, b))
}

/// Locks even after a panic of another thread, which is passed on at the end anyway.
fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

fn into_inner<T>(mutex: Mutex<T>) -> T {
    mutex.into_inner().unwrap_or_else(PoisonError::into_inner)
}
