package rasterlab.exercises.judging;

import java.lang.ref.SoftReference;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Predicate;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import rasterlab.engine.study.LimitReached;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Mutant;
import rasterlab.engine.study.Topic;
import rasterlab.exercises.score.Cause;
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

    /** The answer of each, worked out once, as long as there is place for it. */
    private SoftReference<Map<String, Optional<O>>> outputs =
            new SoftReference<>(new ConcurrentHashMap<>());

    /**
     * @param right the right answer that is nearest to one
     */
    KnownMistakes(ByTopic<C, I, O> grading, I input, Demand demand, UnaryOperator<O> right) {
        this.grading = grading;
        this.topic = grading.topic();
        this.input = input;
        this.demand = demand;
        this.right = right;
    }

    /** Each explains the answer by itself. */
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
                found.add(List.of(new Cause(one.name(), grading.told(one.name()))));
        return found;
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
