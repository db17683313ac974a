//! The longer help texts: what the program is about, and examples for every command.

mod aperiodic;
mod dappled;
mod textures;

pub use aperiodic::*;
pub use dappled::*;
pub use textures::*;

/// About the program.
pub const PROGRAM: &str = "\
Finds, counts, lists, verifies and draws packings of corner tiles, Wang tiles and dominoes on a \
torus.

A corner tile is a square with a color on each corner, a Wang tile one with a color on each edge, \
a domino a segment with a color on each end. A packing uses every tile of a set exactly once, \
neighbors agree on the colors they share, and the last row and column meet the first.

Results go to standard output, everything else to standard error.";

/// Examples for the program.
pub const EXAMPLES: &str = "\
Examples:
  tilepack find --kind corner --colors 3           a packing of the 81 corner tiles over 3 colors
  tilepack find --kind corner --colors 3 -o p.json; tilepack show p.json
  tilepack count --kind wang --colors 2            how many packings of the 16 Wang tiles there are
  tilepack count --kind corner --colors 2 --up-to-symmetry
  tilepack estimate --kind corner --colors 3 --time-limit 1m   about how many, how long to count
  tilepack count --kind corner --colors 3 --checkpoint c3.checkpoint --time-limit 1m
  tilepack list --kind corner --colors 2 -o all.jsonl; tilepack verify all.jsonl

Exit codes:
  0   done, and the answer is yes (found, valid, counted)
  1   done, and the answer is no (not a packing, none exists)
  2   wrong usage, or unreadable, malformed or contradictory input
  75  stopped early by a signal or a limit";

/// Examples for `find`.
pub const FIND: &str = "\
All dominoes, all Wang tiles and all corner tiles over any number of colors have packings in \
closed form, for most shapes of the torus; compact sets are constructed in many shapes. What is \
known is constructed, unless an option asks for a search (--order, --values random, --plain, \
--pin, --automorphism, --cover, --checkpoint or --status). Other compact corner sets of up to 8 \
colors are annealed, pruned sets of 100 to 1000 tiles packed by beam search, where that can work; \
all else is searched exhaustively. It is said which, and why.

Without -o the packing is written to standard output as a text grid that verify and show read. \
What is found is checked from the definition before it is written. The same options give the \
same packing, whatever the number of threads.

Examples:
  tilepack find --kind corner --colors 3
  tilepack find --kind corner --colors 3 --method search
  tilepack find --kind corner --colors 3 --set compact --size 9x6 -o compact.json
  tilepack find --kind corner --colors 4 --automorphism 4,0:1,2,3,0 --values random --seed 7
  tilepack find --kind wang --colors 2,3 --order diagonal
  tilepack find --kind corner --colors 64 -o all.json      # 16777216 tiles, in closed form
  tilepack find --kind corner --colors 3 --method construct --size 27x3 --seed 5
  tilepack find --kind corner --colors 2 --pin begun.txt    # a grid with . for free cells
  tilepack find --kind corner --colors 2 --method beam --pin begun.txt
  tilepack find --kind wang --colors 4 --ring wei -o recursive.json
  tilepack find --kind corner --colors 4 --recursive --seed 24 -o recursive.json
  tilepack find --kind corner --colors 4 --method beam --seed 3
  tilepack find --kind corner --colors 3 --method beam --first-row all
  tilepack find --kind wang --colors 3 --method search --restarts 50000 --seed 2
  tilepack find --kind corner --colors 4 --method portfolio --symmetric
  tilepack find --kind corner --colors 6 --set pruned:0-1,2-3,4-5 --size 77x6 --method beam
  tilepack find --kind corner --colors 5 --set pruned:0-1 --cover --method anneal --aspect 2

With --restarts a search is begun again and again in new random orders, after as many nodes as the \
Luby sequence says; where most orders are bad and some are good this finds the good ones. It is still \
a complete search: at last a run is long enough to say that there is no packing. --values highest \
tries the largest color (or tile number) first: with colors that come into use in order, new ones \
early.

--method portfolio gives several ways their turns, in rounds of twice as many nodes each: search in \
order and in random order, beam search (corner tiles), and with --symmetric search among packings \
with the automorphism that --automorphism auto would take. The first turn, by number, that ends with \
an answer gives it; which way that was, and a symmetry that the packing has, are told.

Beam search goes on, with new random choices by --seed, until it finds a packing or a limit or \
signal stops it; a beam that is wider succeeds more often and takes longer. The last row must fit \
the first, and draws from few tiles when the first has two colors: that is why it has unless \
--first-row all asks for less special packings. --recursive begins \
with the packing over two colors and searches, one color after the other, the packing around the \
one before; it runs on one thread.

Coverings of corner tiles (--cover --method anneal), by annealing and by beam search, under \
symmetries and without: on the torus of --size, or else the smallest that is found in 10 s or \
--time-limit, and the least number of cells that is proved; in JSON set_size, lower_bound, \
bound_reason and how.

JSON fields (--json): result (found, none or stopped; unknown if --method construct knows no \
construction), method (search, construct, anneal, argument, beam or \
portfolio), why (this method, when \
tilepack chose it), width, height, nodes, seconds, file, \
reason (why there is none), construction and source (of what was constructed), stopped_by \
(signal, time-limit or node-limit), seed (of random choices); with --restarts also unit (nodes of the \
shortest runs), run (runs, when stopped); by a portfolio also way, round, turns, automorphism (that \
the packing has); by beam search also beam_width, \
first_row and restart (restarts, when stopped); without -o also the packing itself, with the fields of a solution file. Numbers of \
nodes are strings of digits.";

/// Examples for `locate`.
pub const LOCATE: &str = "\
A construction works both ways, so no packing is written out to look a tile up. The packing is \
the one that find --method construct gives with the same options. Rows and columns count from 0, \
rows from the north, columns from the west.

Examples:
  tilepack locate --kind corner --colors 64 12345 16777215
  tilepack locate --kind corner --colors 3 0,1,2,0         # NE 0, SE 1, SW 2, NW 0
  tilepack locate --kind wang --colors 2,3 --json 7
  tilepack locate --kind wang --colors 5 --ring wei 123

JSON fields (--json): kind, colors, width, height, construction, source, seed, tiles, a list with \
one object for each tile: tile, row, column; result unknown and reason if no construction is known.";

/// Examples for `count`.
pub const COUNT: &str = "\
Packings count as different when any cell differs. The search removes symmetry first and \
multiplies it back exactly; with --up-to-symmetry the sizes of the orbits must add up to the \
same number.

Rings of dominoes are the Eulerian circuits of a graph, and the BEST theorem counts those of any \
set at once; larger sets are counted so unless an option asks for a search.

--method meet counts without looking at packings one by one, by two halves that meet. Corner \
tiles on a torus with short rows or columns: for every choice of row 0 and of a row half way, the \
halves between them are matched by the tiles they use. Up to 64 Wang tiles, or squares on a board: \
partial packings that use the same tiles and show the same colors are counted as one. Nodes are \
then the choices, and steps the halves looked at. It is saved, resumed and divided (plan --meet) \
like any other count.

Examples:
  tilepack count --kind corner --colors 2
  tilepack count --kind corner --colors 2 --up-to-symmetry
  tilepack count --kind domino --colors 4
  tilepack count --kind domino --colors 12 --method formula
  tilepack count --kind corner --colors 3 --automorphism 3,0:+1
  tilepack count --kind corner --colors 3 --automorphism 3,0:+1 --method meet
  tilepack count --kind corner --colors 3 --time-limit 1m       # too many to count: at least ...

JSON fields (--json): result (complete or stopped), solutions, fundamental (with \
--up-to-symmetry), up_to_translation (null where translates may coincide), nodes, seconds, \
method, reason, stopped_by, and with --method meet steps. Numbers of packings, nodes and steps \
are strings of digits; when stopped they are lower bounds.";

/// Examples for `list`.
pub const LIST: &str = "\
The list is sorted, so that it does not depend on the number of threads. It is held in memory, \
one byte or two a cell, before it is written.

Examples:
  tilepack list --kind corner --colors 2 -o all.jsonl
  tilepack list --kind wang --colors 2 --up-to-symmetry | head -1 | tilepack show -
  tilepack list --kind domino --colors 3 | tilepack verify -

JSON fields (--json): result (complete or stopped), solutions (a string of digits: the number of \
lines in the file), file, nodes, seconds, reason, stopped_by.";

/// Examples for `estimate`.
pub const ESTIMATE: &str = "\
Walks a random part of the search tree, again and again, and infers the whole: the number of \
packings and the number of nodes that count would visit, each with a 95 % interval (one in \
twenty intervals misses). Here --node-limit is the effort: about so many nodes are probed \
(default 250 million), and the same seed gives the same numbers whatever the number of threads. \
Four times the effort halves the interval. A tree much smaller than that is searched completely; \
then the numbers are exact. Where no probe reaches a packing there is no estimate of their number.

Examples:
  tilepack estimate --kind corner --colors 3
  tilepack estimate --kind corner --colors 3 --node-limit 2000000000 --seed 7
  tilepack estimate --kind corner --colors 3 --set compact --size 9x6 --json

JSON fields (--json): result (complete or stopped), nodes, nodes_low, nodes_high, solutions, \
solutions_low, solutions_high (strings of digits, null where there is no estimate), exact, method \
(probes, search or argument), reason, nodes_probed, replicates, seed, stopped_by, seconds, \
nodes_per_second (of the exact search on one thread, measured), core_years (that a count would \
take at that rate).";

/// Examples for `verify`.
pub const VERIFY: &str = "\
A packing is right when every tile belongs to the set, neighbors agree on the colors they share, \
also across both seams, and every tile occurs exactly once. (In a covering, --cover, at least \
once. Of a compact set, exactly two tiles for each choice of the fixed colors.)

Files of cubes are recognized by their kind, and checked in space. Certificates of aperiodic sets \
(aperiodic color) are recognized by their vertex_rule, and checked step by step with exact numbers: \
what is proved and what is taken on trust is told, or the first step that fails (exit code 1). In JSON \
they have also tiles, pieces, windows, condition, ambiguous, proved and assumed.

A bare grid says neither its kind nor its colors: give --kind and --colors. Where a file and the \
options both speak, they must agree. Rows and columns in messages count from 0.

With --recursive a packing must also be recursive (Lagae 2007, figure 5.11): its south-west block \
of (C-1)^2 x (C-1)^2 tiles is a packing over the first C-1 colors that closes on its own, and is \
recursive itself, down to two colors. The blocks are told.

Exit code: 0 all valid, 1 some packing is not valid (not recursive), 2 some file cannot be read or \
has a size that does not match its set.

Examples:
  tilepack verify packing.json all.jsonl
  tilepack verify --kind corner --colors 4 grid.txt
  tilepack verify --recursive packing.json
  tilepack find --kind wang --colors 3 | tilepack verify -

JSON fields (--json): files, a list with one object for each file: file, valid, kind, colors, \
width, height, set, topology (those of the first packing; null if there is none), packings (how \
many were read), error (null if valid; else the first fault); with --recursive also recursive (the \
number of blocks, each in the one before; of several packings the least).";

/// Examples for `show`.
pub const SHOW: &str = "\
Corner tiles: the colors stand at the corners, each shared by four tiles. Wang tiles: the colors \
stand at the edges. Where neighbors do not fit, a drawing without colors has an x, a drawing with \
colors shows what each tile has. Colors are written 0-9, a-z, A-Z (numbers if there are more).

Examples:
  tilepack find --kind corner --colors 3 | tilepack show -
  tilepack show --indices packing.json
  tilepack show --color always packing.json | less -R
  tilepack show --kind corner --colors 4 grid.txt";

/// Examples for `sets`.
pub const SETS: &str = "\
The size is that of a formula, and is checked by listing the tiles unless there are more than \
2^26 to look at.

A tile has one number. Corner: ((NE*C + SE)*C + SW)*C + NW. Wang: ((N*CV + E)*CH + S)*CV + W. \
Domino: first*C + second.

Examples:
  tilepack sets --kind corner --colors 4
  tilepack sets --kind corner --colors 3 --set pruned:0-1 --list
  tilepack sets --kind wang --colors 2,3 --list --json

JSON fields (--json): size (a string of digits), tiles (with --list), kind, colors, set, checked \
(whether the size was also found by listing).";

/// Examples for `export-cnf`.
pub const EXPORT_CNF: &str = "\
Every packing is exactly one model, so a program that counts models counts packings. Comments in \
the file say what the variables are. Nothing is left out: to keep only one of the translates of \
each packing, pin a tile.

Examples:
  tilepack export-cnf --kind corner --colors 3 -o corner.cnf
  cadical corner.cnf > corner.out; tilepack export-cnf --kind corner --colors 3 --model corner.out
  tilepack export-cnf --kind corner --colors 3 --automorphism 3,0:+1 | minisat /dev/stdin

Exit codes with --model: 0 a packing, 1 the solver says that there is none, 75 it gave no answer, \
2 what it says is no packing.

JSON fields (--json): result (written), format, variables, clauses, file; with --model result \
(found, none or stopped), method, width, height, reason, file, and without -o the solution.";

/// Examples for `export-xcc`.
pub const EXPORT_XCC: &str = "\
Cells and tiles are items, lattice points (for Wang tiles, edges) secondary items with colors; an \
option is a tile in a cell. Coverings and compact sets need multiplicities, which DLX3 has. A \
covering of a compact set cannot be said.

Examples:
  tilepack export-xcc --kind corner --colors 2 -o corner.dlx; dlx2 < corner.dlx
  tilepack export-xcc --kind corner --colors 2 --set compact | dlx3

JSON fields (--json): result (written), format (xcc or xcc with multiplicities), items, \
secondary_items, options, file.";

/// Examples for `walk`.
pub const WALK: &str = "\
Takes the tiles of a random patch out of a packing (or covering, of any set and kind), finds all \
ways to put the same tiles back, and goes on to another one at random, again and again. Whatever \
comes out is a packing with the same tiles, checked from the definition.

Each packing that differs in the patch only is reached with the same probability, there and back. So \
the walk favors none of the packings that it connects: in the long run it visits them equally often. \
Whether it connects all packings of a set, and how long the long run is, is not known. Larger patches \
more often have another filling, and take longer.

Drift says how unequally the rows (columns) use the colors: 1 is as at random, less is more even; \
beam search uses some colors up early.

A signal or --time-limit ends the walk early with exit code 75; the packing is written all the same.

Examples:
  tilepack find --kind corner --colors 4 --method beam -o four.json
  tilepack walk four.json --steps 1000 -o other.json
  tilepack walk four.json --patch 8x8 --steps 100 --seed 7 --json
  tilepack find --kind wang --colors 3 | tilepack walk - --patch 4x4

JSON fields (--json): result (walked or stopped), stopped_by, width, height, seed, patch, steps, moves (patches that \
had another filling), skipped (patches left alone because their fillings took too long), fillings and \
nodes (of all patches; these numbers are strings of digits), changed (cells with another tile than at \
the start), drift_rows and drift_columns (before and after), rows_before and rows_after (for every row \
how often it shows each color; of Wang tiles first the colors of north edges, then of west edges), \
seconds, file; without -o also the packing itself.";

/// Examples for `cube`.
pub const CUBE: &str = "\
A corner cube has a color on each of eight corners, a Wang cube one on each of six faces. All of \
them over some colors fill a torus in space, each once, neighbors matching, in closed form: corner \
cubes as a stack of shifted copies of the packing of corner tiles, Wang cubes as a product of three \
rings. What is constructed is checked from the definition before it is written; verify checks it \
again.

Examples:
  tilepack cube --kind corner --colors 3 -o cubes.json; tilepack verify cubes.json
  tilepack cube --kind corner --colors 2 --size 8x8x4
  tilepack cube --kind wang --colors 2,3,2 --seed 7

JSON fields (--json): result, method, construction, cubes (how many, a string of digits), seed, \
seconds, file, format, kind, colors, set, width, height, depth, topology; without -o also layers, \
so that the object is a solution file, too.";

/// Examples for `resume`.
pub const RESUME: &str = "\
The checkpoint says which search it is, how it was to be done and where the answer goes; limits \
and the number of threads may be others. When the newest checkpoint is damaged, the one before \
it is taken, with a warning. A search that is complete gives its answer again. Running the same \
command with the same --checkpoint FILE does the same.

Examples:
  tilepack count --kind corner --colors 3 --checkpoint c3.checkpoint --time-limit 1h
  tilepack resume c3.checkpoint
  tilepack resume c3.checkpoint --threads 1 --status c3.json --checkpoint-every 10m

JSON fields (--json): those of the command that began the search, and checkpoint.";

/// Examples for `plan`.
pub const PLAN: &str = "\
The nodes at one depth of the search tree are dealt out to the parts, by a hash of the choices \
that lead to them: part R of M is the union of the parts R, R+M, R+2M, ... of a plan with a \
multiple of M parts and the same depth. A part needs nothing of the others, so parts may run \
anywhere, in any order, with any number of threads.

Examples:
  tilepack plan --kind wang --colors 2 --parts 16 -o wang.plan
  tilepack run wang.plan --part 0                # and so on to 15: see tilepack cluster
  tilepack merge wang.plan

JSON fields (--json): result (planned, or none when it is plain that there is no packing), parts, \
done, file, plan (the name of the plan: its checksum), depth, frontier, above (nodes at that \
depth, and above it).";

/// Examples for `run`.
pub const RUN: &str = "\
May be run again at any time: a part that is done ends at once with 0, one that was stopped goes \
on from its checkpoint, one that another process is at work on is left to it with 75. A signal or \
a limit saves the part and exits with 75. DIR then holds part-R.result.json, and before that \
part-R.checkpoint.

Examples:
  tilepack run wang.plan --part 3
  tilepack run wang.plan --part 3 --dir /shared/wang --threads 1 --time-limit 1h

JSON fields (--json): result (complete or stopped), part, parts, done (1 or 0), solutions_met (null for plan --meet), \
nodes, seconds, stopped_by, checkpoint.";

/// Examples for `merge`.
pub const MERGE: &str = "\
Gives the answer of the undivided search: the same number, the same nodes, for a list the same \
bytes. While parts are missing it names them and exits with 75. Results of another plan, another \
version or twice the same part are refused.

Examples:
  tilepack merge wang.plan
  tilepack merge list.plan --dir /shared/list -o all.jsonl

JSON fields (--json): parts, done, missing (when there are any), and those of count or list. \
seconds is the sum over the parts.";

/// Examples for `cluster`.
pub const CLUSTER: &str = "\
The script is run with sh, once; options after its name go to the scheduler. Run it again when \
parts are missing: finished parts end at once, the others go on from their checkpoints. Paths in \
it are absolute; plan and parts lie on a disk that all nodes share.

Examples:
  tilepack plan --kind wang --colors 2 --parts 64 -o plan.json
  tilepack cluster slurm plan.json --time 24:00:00 -o plan.slurm
  sh plan.slurm --partition=long
  tilepack merge plan.json

  tilepack cluster hyperqueue plan.json --threads 4 -o plan.hq; sh plan.hq
  tilepack cluster parallel plan.json -o plan.parallel; sh plan.parallel --eta";
