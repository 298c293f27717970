package rasterlab.exercises.judging;

import java.lang.ref.SoftReference;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Predicate;
import java.util.function.Supplier;
import java.util.function.UnaryOperator;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import rasterlab.engine.raster.PixelRecording;
import rasterlab.engine.study.LimitReached;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Mutant;
import rasterlab.engine.study.Slip;
import rasterlab.engine.study.Topic;
import rasterlab.exercises.score.Cause;
import rasterlab.exercises.score.KnownChanges;
import rasterlab.exercises.score.Message;

/**
 * The topic's mutants and faulty methods that give the very answer which a student's method gave.
 */
final class KnownMistakes<C, I, O> {
    private static final System.Logger LOG = System.getLogger(KnownMistakes.class.getName());

    private final ByTopic<C, I, O> grading;
    private final Topic<C, I, O> topic;
    private final I input;
    private final Demand demand;
    private final UnaryOperator<O> right;
    private final Supplier<O> truth;

    /** The answer of each, worked out once, as long as there is place for it. */
    private SoftReference<Map<String, Optional<O>>> outputs =
            new SoftReference<>(new ConcurrentHashMap<>());

    /**
     * @param right the right answer that is nearest to one
     * @param truth the right answer, whatever a method gave
     */
    KnownMistakes(
            ByTopic<C, I, O> grading,
            I input,
            Demand demand,
            UnaryOperator<O> right,
            Supplier<O> truth) {
        this.grading = grading;
        this.topic = grading.topic();
        this.input = input;
        this.demand = demand;
        this.right = right;
        this.truth = truth;
    }

    /**
     * Each explains the answer by itself. Where no method is known to give it, the changes of the
     * right answer by which it comes.
     */
    List<List<Cause>> of(O actual) {
        List<List<Cause>> found = new ArrayList<>();
        Predicate<O> same = sameAs(actual);
        for (Mutant<C> one : mutants())
            if (kept("mutant " + one.name(), one.implementation()).filter(same).isPresent()) {
                String text = "mutant." + topic.name() + "." + one.name();
                found.add(List.of(new Cause(one.name(), Message.of("known-mistake", text))));
            }
        for (Method<C> one : topic.methods())
            if (one.faulty()
                    && kept("method " + one.name(), one.implementation()).filter(same).isPresent())
                found.add(List.of(new Cause(one.name(), grading.knownFault(one.name()))));
        if (found.isEmpty()) found.addAll(slips(same));
        return found.isEmpty() ? changes(actual) : found;
    }

    private List<List<Cause>> slips(Predicate<O> same) {
        List<List<Cause>> found = new ArrayList<>();
        for (Slip<C> one : topic.slips(asked()))
            if (answers(one).anyMatch(same)) {
                String text = "slip." + topic.name() + "." + one.name();
                found.add(List.of(new Cause(one.name(), Message.of("known-mistake", text))));
            }
        return found;
    }

    /** A right method of what the exercise asks for. */
    private C asked() {
        return demand.tolerance()
                .truth()
                .map(name -> topic.method(name).implementation())
                .orElseGet(() -> grading.whole(grading.plain()));
    }

    private Stream<O> answers(Slip<C> slip) {
        return IntStream.range(0, slip.forms().size())
                .mapToObj(i -> kept("slip " + slip.name() + i, slip.forms().get(i)))
                .flatMap(Optional::stream);
    }

    /** Answers in one order have explanations of their own. */
    private List<List<Cause>> changes(O actual) {
        if (grading.isInOrder()) return List.of();
        O wanted = right.apply(actual);
        List<Cause> changes =
                wanted instanceof PixelRecording one && actual instanceof PixelRecording other
                        ? KnownChanges.of(one, other)
                        : KnownChanges.of(grading.json(input, wanted), grading.json(input, actual));
        return changes.stream().map(List::of).toList();
    }

    /** Whether a wrong answer comes by the topic's slip of that name. */
    boolean comesBySlip(String name, O actual) {
        return topic.slips(asked()).stream()
                .filter(one -> one.name().equals(name))
                .flatMap(this::answers)
                .anyMatch(sameAs(actual));
    }

    /** Whether a wrong answer comes by that change of the right one. */
    boolean comesBy(String change, O actual) {
        O wanted = right.apply(actual);
        return wanted instanceof PixelRecording one && actual instanceof PixelRecording other
                ? KnownChanges.makes(change, one, other)
                : KnownChanges.makes(
                        change, grading.json(input, wanted), grading.json(input, actual));
    }

    private boolean isRightChanged(String code) {
        return truth.get() instanceof PixelRecording pixels
                ? KnownChanges.leaves(code, pixels)
                : KnownChanges.leaves(code, grading.json(input, truth.get()));
    }

    /** Whether these are one mistake: a mutant may be a faulty method by another name. */
    boolean areOne(List<List<Cause>> causes) {
        if (causes.size() != 2) return causes.size() == 1;
        String mutant = causes.get(0).get(0).code();
        String method = causes.get(1).get(0).code();
        boolean ofBothKinds =
                mutants().stream().anyMatch(one -> one.name().equals(mutant))
                        && topic.methods().stream().anyMatch(one -> one.name().equals(method));
        return ofBothKinds
                && Stream.concat(named(mutant), named(method))
                                .map(Object::getClass)
                                .distinct()
                                .count()
                        == 1;
    }

    private List<Mutant<C>> mutants() {
        return topic.mutants(demand.tolerance().truth());
    }

    private Stream<C> named(String name) {
        Stream<C> mutants =
                mutants().stream()
                        .filter(one -> one.name().equals(name))
                        .map(Mutant::implementation);
        Stream<C> methods =
                topic.methods().stream()
                        .filter(one -> one.name().equals(name))
                        .map(Method::implementation);
        return Stream.concat(mutants, methods);
    }

    /** Whether the mistake of that name does not show on this input; so does one not known here. */
    boolean isRightWith(String name) {
        if (KnownChanges.isOne(name)) return isRightChanged(name);
        for (Slip<C> one : topic.slips(asked()))
            if (one.name().equals(name)) return answers(one).anyMatch(this::isRight);
        return Stream.concat(
                        mutants().stream()
                                .filter(one -> one.name().equals(name))
                                .map(one -> kept("mutant " + name, one.implementation())),
                        topic.methods().stream()
                                .filter(one -> one.name().equals(name))
                                .map(one -> kept("method " + name, one.implementation())))
                .allMatch(given -> given.filter(this::isRight).isPresent());
    }

    /** An answer within the exercise's tolerance does not tell one mistake from another. */
    private Predicate<O> sameAs(O actual) {
        Predicate<O> right = known -> grading.isRight(input, known, actual, demand.tolerance());
        return right.or(grading.sameAs(input, actual));
    }

    private boolean isRight(O output) {
        return sameAs(output).test(right.apply(output));
    }

    private Optional<O> kept(String name, C method) {
        Map<String, Optional<O>> known = outputs.get();
        if (known == null) {
            known = new ConcurrentHashMap<>();
            outputs = new SoftReference<>(known);
        }
        return known.computeIfAbsent(name, none -> output(method));
    }

    /**
     * The method's answer, empty where it refuses, goes on without end or breaks down, as a faulty
     * one may.
     */
    @SuppressWarnings("unchecked") // what is recorded is an output of the topic
    private Optional<O> output(C method) {
        try {
            return Optional.of(topic.record(method, input, most()));
        } catch (LimitReached reached) {
            return demand.cut() ? Optional.of((O) reached.recorded()) : Optional.empty();
        } catch (IllegalArgumentException refused) {
            return Optional.empty();
        } catch (RuntimeException | StackOverflowError broken) {
            LOG.log(System.Logger.Level.DEBUG, "a known faulty method breaks down here", broken);
            return Optional.empty();
        }
    }

    private int most() {
        return demand.cut() ? demand.items() : topic.mostItems();
    }
}
