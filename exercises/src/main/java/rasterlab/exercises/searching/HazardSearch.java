package rasterlab.exercises.searching;

import com.fasterxml.jackson.databind.JsonNode;
import java.time.Duration;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.function.BooleanSupplier;
import java.util.function.Function;
import rasterlab.engine.Topics;
import rasterlab.engine.naming.Named;
import rasterlab.engine.study.Guard;
import rasterlab.engine.study.HazardTrial;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Mutant;
import rasterlab.engine.study.Topic;
import rasterlab.engine.study.Verdict;

/**
 * Searches for an input on which a method is wrong, crashes or comes to no end, though a method
 * that promises to be right is exact there.
 *
 * <p>Each input is either drawn from the topic's description or made of one that is kept, by a few
 * changes. Kept are the study's own inputs and those that bring a worse error than all before. A
 * method that is never wrong but sometimes inexact is told by such an input when the time is over;
 * so is a mutant that refuses an input for which all methods that promise to be right are exact.
 */
public final class HazardSearch<C, I, O> {
    /** The wall time of one method, and of the exact answer, for one input. */
    private static final Duration LIMIT = Duration.ofSeconds(1);

    /** Time limit where an input is tried once more because something took longer. */
    private static final Duration PATIENT = Duration.ofSeconds(8);

    /** The part of the time that goes to such inputs, and how many wait. */
    private static final double PATIENCE = 0.25;

    private static final int MOST_WAITING = 8;

    private static final Duration SLOW = Duration.ofMillis(300);
    private static final long TELL_NANOS = 1_000_000_000L;
    private static final int MOST_KEPT = 60;

    /** Time left to make an inexact input simpler, if the whole time is five times as long. */
    private static final Duration SHRINKING = Duration.ofSeconds(3);

    /** Time to make simpler what is found as the time ends. */
    private static final Duration LEAST_SHRINKING = Duration.ofSeconds(1);

    /** Time after the end in which a search ends by itself; then it is left behind. */
    private static final Duration GRACE = LEAST_SHRINKING.plusMillis(500);

    private final Topic<C, I, O> topic;
    private final Method<C> method;
    private final boolean mutant;

    /** Whether only inputs count for which the topic's methods promise to be right. */
    private final boolean promising;

    private final List<Method<C>> witnesses;
    private final SearchedInputs<C, I, O> inputs;
    private final int seed;
    private final LastFind listener;
    private final Random random;
    private final TreeMutation mutation;
    private final List<JsonNode> kept = new ArrayList<>();
    private final long start = System.nanoTime();
    private double worst;
    private BooleanSupplier over = () -> false;

    /** Inputs on which something took too long. */
    private final Deque<JsonNode> waiting = new ArrayDeque<>();

    private long patientNanos;
    private Duration limit = LIMIT;

    /** Whether something took too long on the last input. */
    private boolean late;

    private volatile long tried;
    private int asked;
    private int drawn;
    private int slow;

    /** Place among the kept ones of what was changed last; -1 where it was drawn. */
    private int changedOf = -1;

    /** An input that tells the method where none on which it fails is found. */
    private Optional<Failing> inexact = Optional.empty();

    /** A tree on which the method earned that verdict. */
    private record Failing(JsonNode tree, Verdict verdict) {}

    private HazardSearch(
            Topic<C, I, O> topic,
            Method<C> method,
            boolean mutant,
            int seed,
            SearchListener listener) {
        this.topic = topic;
        this.method = method;
        this.mutant = mutant;
        this.seed = seed;
        this.listener = new LastFind(listener);
        witnesses =
                topic.methods().stream()
                        .filter(Method::promisesToBeRight)
                        .filter(each -> !each.name().equals(method.name()))
                        .toList();
        promising = !mutant && method.promisesToBeRight();
        inputs = new SearchedInputs<>(topic, method.name(), method.implementation());
        random = new Random(seed);
        mutation = new TreeMutation(random);
    }

    /**
     * Makes ready to search.
     *
     * @param method a method of the topic, or one of its mutants
     * @param seed of what is drawn
     * @throws IllegalArgumentException if there is no such topic or method; lists those there are
     */
    public static HazardSearch<?, ?, ?> of(
            String topic, String method, int seed, SearchListener listener) {
        return of(Topics.named(topic), method, seed, listener);
    }

    static <C, I, O> HazardSearch<C, I, O> of(
            Topic<C, I, O> topic, String method, int seed, SearchListener listener) {
        for (Mutant<C> mutant : topic.allMutants())
            if (mutant.name().equals(method))
                return new HazardSearch<>(
                        topic,
                        Method.failing(method, mutant.implementation()),
                        true,
                        seed,
                        listener);
        Method<C> named =
                Named.find(topic.name() + " method", method, topic.methods(), Method::name);
        return new HazardSearch<>(topic, named, false, seed, listener);
    }

    /**
     * Searches until something is found or the time is over, and at most two seconds longer,
     * whatever a method, an exact answer or a comparison does: one that comes to no end is left
     * behind.
     *
     * @param cancelled asked before each input and each call, on a thread of the search's own
     */
    public Optional<Find> search(Duration time, BooleanSupplier cancelled) {
        long deadline = start + time.toNanos();
        return listener.within(
                () -> searched(deadline, time, cancelled),
                Duration.ofNanos(deadline - System.nanoTime()).plus(GRACE));
    }

    private Optional<Find> searched(long deadline, Duration time, BooleanSupplier cancelled) {
        long shrinking = Math.min(SHRINKING.toNanos(), time.toNanos() / 5);
        over =
                () ->
                        cancelled.getAsBoolean()
                                || System.nanoTime() - deadline
                                        >= (inexact.isPresent() ? -shrinking : 0);
        kept.addAll(inputs.ofStudy());
        long next = start + TELL_NANOS;
        while (!over.getAsBoolean()) {
            boolean patient = !waiting.isEmpty() && patientNanos < PATIENCE * passed().toNanos();
            JsonNode tree = patient ? waiting.remove() : next();
            Optional<Failing> failing =
                    tree == null ? Optional.empty() : patient ? patiently(tree) : tried(tree);
            if (failing.isPresent()) return Optional.of(shrunk(failing.get(), deadline, cancelled));
            if (System.nanoTime() - next < 0) continue;
            listener.tried(tried);
            next += TELL_NANOS;
        }
        return inexact.map(failing -> shrunk(failing, deadline, cancelled));
    }

    /** How many inputs were tried so far. */
    public long inputsTried() {
        return tried;
    }

    private JsonNode next() {
        boolean drawing = kept.isEmpty() || random.nextInt(5) < 2 && worthDrawing();
        changedOf = drawing ? -1 : random.nextInt(kept.size());
        if (!drawing) return mutation.changed(kept.get(changedOf));
        asked++;
        Optional<JsonNode> tree = inputs.drawn(random, slow > 0 && random.nextInt(8) > 0);
        if (tree.isEmpty()) return null;
        drawn++;
        return tree.get();
    }

    /** Few descriptions say so little that hardly anything drawn from them is an input. */
    private boolean worthDrawing() {
        return asked < 400 || 50L * drawn > asked;
    }

    /** Tries an input again with more time; what fails there is made simpler with it too. */
    private Optional<Failing> patiently(JsonNode tree) {
        long began = System.nanoTime();
        limit = PATIENT;
        changedOf = -1;
        Optional<Failing> failing = tried(tree);
        if (failing.isEmpty()) limit = LIMIT;
        patientNanos += System.nanoTime() - began;
        return failing;
    }

    private Optional<Failing> tried(JsonNode tree) {
        Optional<I> input = inputs.read(tree);
        if (input.isEmpty()) return Optional.empty();
        tried++;
        long began = System.nanoTime();
        if (promising && !topic.isPromised(input.get())) return Optional.empty();
        Optional<Verdict> verdict = verdict(input.get());
        if (System.nanoTime() - began > SLOW.toNanos()) forget();
        if (verdict.isEmpty() && late && limit == LIMIT && waiting.size() < MOST_WAITING)
            waiting.add(tree);
        if (verdict.isEmpty()) return Optional.empty();
        var here = new Failing(tree, verdict.get());
        if (fails(here.verdict.kind())) return Optional.of(here);
        boolean mild =
                here.verdict.kind() == Verdict.Kind.DEGRADED
                        || here.verdict.kind() == Verdict.Kind.REFUSED && mutant;
        if (mild && inexact.isEmpty()) {
            inexact = Optional.of(here);
            listener.keep(find(tree, here.verdict, tried, passed()));
        }
        keep(here);
        return Optional.empty();
    }

    /** An input that takes long is not changed again: hundreds of others can be tried instead. */
    private void forget() {
        slow++;
        if (changedOf >= 0 && kept.size() > 1) kept.remove(changedOf);
        changedOf = -1;
    }

    private void keep(Failing here) {
        double error = here.verdict.deviation().worst();
        if (!(error > worst)) return;
        worst = error;
        if (kept.size() < MOST_KEPT) kept.add(here.tree);
        else kept.set(random.nextInt(MOST_KEPT), here.tree);
    }

    private static boolean fails(Verdict.Kind kind) {
        return kind == Verdict.Kind.WRONG
                || kind == Verdict.Kind.ENDLESS
                || kind == Verdict.Kind.CRASHED;
    }

    /**
     * The verdict on the method for an input; empty where it says nothing of the method, or the
     * time is over before that is known.
     */
    private Optional<Verdict> verdict(I input) {
        late = false;
        Duration most = limit;
        var exact = Guard.call("exact answer", () -> HazardTrial.judging(topic, input, most), most);
        if (!(exact instanceof Guard.Returned<Function<Method<C>, Verdict>> judging)) {
            late = exact instanceof Guard.TimedOut;
            return Optional.empty();
        }
        if (over.getAsBoolean()) return Optional.empty();
        Verdict verdict = judging.value().apply(method);
        boolean refused = verdict.kind() == Verdict.Kind.REFUSED;
        if (verdict.kind() == Verdict.Kind.EXACT || refused && !mutant) return Optional.of(verdict);
        boolean witnessed =
                refused
                        ? witnesses.stream().allMatch(each -> isExact(judging.value(), each))
                        : witnesses.isEmpty()
                                || witnesses.stream()
                                        .anyMatch(each -> isExact(judging.value(), each));
        return witnessed ? Optional.of(verdict) : Optional.empty();
    }

    private boolean isExact(Function<Method<C>, Verdict> judging, Method<C> each) {
        if (over.getAsBoolean()) return false;
        Verdict.Kind kind = judging.apply(each).kind();
        late |= kind == Verdict.Kind.ENDLESS;
        return kind == Verdict.Kind.EXACT;
    }

    private Duration passed() {
        return Duration.ofNanos(System.nanoTime() - start);
    }

    private Find shrunk(Failing first, long deadline, BooleanSupplier cancelled) {
        Duration after = passed();
        long inputsTried = tried;
        listener.found(find(first.tree, first.verdict, inputsTried, after));
        long now = System.nanoTime();
        long end = now + Math.max(deadline - now, LEAST_SHRINKING.toNanos());
        over = () -> cancelled.getAsBoolean() || System.nanoTime() - end >= 0;
        var last = new Verdict[] {first.verdict};
        JsonNode best =
                new TreeShrinking(
                                tree -> failsAs(first, tree, last),
                                tree -> listener.simpler(find(tree, last[0], inputsTried, after)),
                                over)
                        .shrunk(first.tree);
        return find(best, last[0], inputsTried, after);
    }

    private boolean failsAs(Failing first, JsonNode tree, Verdict[] last) {
        Optional<Verdict> verdict = inputs.read(tree).flatMap(this::verdict);
        if (verdict.isEmpty() || verdict.get().kind() != first.verdict.kind()) return false;
        last[0] = verdict.get();
        return true;
    }

    private Find find(JsonNode tree, Verdict verdict, long inputsTried, Duration after) {
        return new Find(
                topic.name(), method.name(), verdict, tree.toString(), seed, inputsTried, after);
    }
}
