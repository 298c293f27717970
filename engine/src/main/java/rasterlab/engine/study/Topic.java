package rasterlab.engine.study;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import rasterlab.engine.naming.Named;
import rasterlab.engine.predicate.PointQuestion;

/**
 * One task of the course: its contract, the methods that solve it, an exact reference and the
 * inputs to try them on.
 *
 * <p>Studies, hazards, labs, exercises and the command line know a task only through this type, so
 * nothing is measured or compared by two different pieces of code.
 *
 * @param <C> the contract that methods implement
 * @param <I> one input
 * @param <O> one recorded output
 */
public interface Topic<C, I, O> {
    /** Lower-case name with hyphens, as on the command line. */
    String name();

    /** Name of the lab that shows it, such as "polygon". */
    String lab();

    /** The interface that methods implement; a student's too, where it is a public contract. */
    Class<C> contract();

    /** All methods, those to recommend and those known to be faulty, in teaching order. */
    List<Method<C>> methods();

    List<Hazard<I>> hazards();

    /** The inputs a study measures, smallest first. */
    List<Workload<I>> workloads();

    /**
     * Five to fifteen implementations with one likely mistake each, which no list of methods shows;
     * an answer equal to that of one tells which mistake was made. They are made anew by each call
     * and serve one thread: a mutant may keep what it should not.
     */
    default List<Mutant<C>> mutants() {
        return List.of();
    }

    /** The mutants to try where not the topic's answer is asked for, but that of one method. */
    default List<Mutant<C>> mutants(String method) {
        return mutants();
    }

    /**
     * The mutants to try on what is asked for.
     *
     * @param method whose answer that is; empty for the topic's
     */
    default List<Mutant<C>> mutants(Optional<String> method) {
        return method.isPresent() ? mutants(method.get()) : mutants();
    }

    /**
     * Mistakes beside the mutants by which a wrong answer is told, tried where no mutant and no
     * faulty method gives it.
     *
     * @param right a method that gives what is asked for
     */
    default List<Slip<C>> slips(C right) {
        return List.of();
    }

    /** The mutants to try on anything that may be asked for; the same one may come again. */
    default List<Mutant<C>> allMutants() {
        var all = new ArrayList<>(mutants());
        for (Method<C> one : methods()) all.addAll(mutants(one.name()));
        return all;
    }

    /**
     * Runs a method on a copy of the input and records what it produced.
     *
     * @param limit the most items to record; a method that goes on beyond it is stopped
     * @throws LimitReached when the method produced more than {@code limit} items; carries what was
     *     recorded
     * @throws InputChanged when the method wrote into what it was only given to read
     * @throws IllegalArgumentException when the method refuses the input
     */
    default O record(C method, I input, int limit) {
        I copy = Inputs.copy(input);
        O recorded = run(method, copy, limit);
        Inputs.requireUnchanged(copy, input);
        return recorded;
    }

    /**
     * Runs a method and records what it produced, as {@link #record} does.
     *
     * @param input the method's own: nothing else reads it
     */
    O run(C method, I input, int limit);

    /**
     * Runs a method as {@link #record} does and keeps what it is judged by: all it produced, or of
     * an answer too long to keep the part that {@link #exactPart} has.
     */
    default O recordPart(C method, I input, int limit) {
        return record(method, input, limit);
    }

    /**
     * Runs a method as fast as it goes, with a sink that only counts, and returns the number of
     * items produced.
     *
     * @param input the method's own: nothing else reads it
     */
    long spend(C method, I input);

    /**
     * The right answer, slow and plain, sharing no code with the methods.
     *
     * @param limit the most items to produce; a longer answer is cut there
     */
    O exact(I input, int limit);

    /**
     * The answer that methods are judged by: the right one, or a part of one too long to keep. A
     * topic whose methods produce items in different orders chooses that part by the items
     * themselves.
     */
    default O exactPart(I input, int limit) {
        return exact(input, limit);
    }

    Deviation compare(I input, O exact, O actual);

    /**
     * Whether an output counts as exact. A topic whose outputs are real numbers allows for the
     * rounding that no method in doubles avoids, and says how much.
     */
    default boolean correct(Deviation deviation) {
        return deviation.exact();
    }

    /** Whether an output that is not exact still serves: degraded rather than wrong. */
    default boolean usable(Deviation deviation) {
        return deviation.exact();
    }

    /**
     * The work of a method on one input, counted instead of timed and so free of noise.
     *
     * @return name in the plural, such as "multiplications", to their number; empty where nothing
     *     is counted
     */
    default Map<String, Long> operations(C method, I input) {
        return Map.of();
    }

    /**
     * Whether a count of {@link #operations} is work; others are measures of the answer.
     *
     * @param count its name
     */
    default boolean isWork(String count) {
        return true;
    }

    /**
     * The thing that counted operations are told per, in the singular: the item, but one input
     * where methods choose how many items their answer has.
     */
    default String countedPer() {
        return item();
    }

    /**
     * The name of the count that says of how many parts an answer is made, where methods choose
     * that; empty where they do not.
     */
    default Optional<String> parts() {
        return Optional.empty();
    }

    /**
     * The most items of {@link #exactPart}; a longer one is cut there and compared by its
     * beginning, which only serves where all methods produce their items in one order.
     */
    default int mostItems() {
        return 20_000;
    }

    /**
     * Whether the methods that promise to be right do so for an input: what {@code ./lab methods}
     * says of each holds there.
     */
    default boolean isPromised(I input) {
        return true;
    }

    /** The question that the topic's answers are signs of, if they are such. */
    default Optional<PointQuestion<I, O>> question() {
        return Optional.empty();
    }

    /**
     * The words that an input may be made of, where the topic has such: how a word is written to
     * its meaning in one line, in teaching order.
     */
    default Map<String, String> vocabulary() {
        return Map.of();
    }

    /** The form of the topic's inputs and answers outside the engine. */
    Format<C, I, O> format();

    /**
     * The unit that {@link #spend} counts, in the singular, for axis labels: "pixel", "segment".
     */
    String item();

    /**
     * Whether the size of a workload says how much there is to do, so that costs and errors may
     * grow with it; otherwise it is another number that tells workloads apart.
     */
    default boolean sized() {
        return true;
    }

    /** Unit of {@link Deviation#worst}. */
    String errorUnit();

    /**
     * The most items a method may produce before it is taken for endless, in a study, a lab, a run
     * or an exercise: twice the right number and 1,000 more.
     *
     * @param exactItems the right number
     */
    default long mostBeforeEndless(long exactItems) {
        return 2 * exactItems + 1_000;
    }

    /**
     * The method of that name.
     *
     * @throws IllegalArgumentException if there is none; the message lists those there are
     */
    default Method<C> method(String name) {
        return Named.find(name() + " method", name, methods(), Method::name);
    }
}
