package rasterlab.exercises.property;

import java.util.List;
import java.util.Optional;
import java.util.function.BiFunction;
import java.util.function.UnaryOperator;
import rasterlab.exercises.score.Message;

/**
 * A relation between a method's answer to an input and its answers to inputs made of that one.
 *
 * @param <I> one input
 * @param <O> one output
 */
public interface Relation<I, O> {
    /**
     * The further inputs; none where the relation is one of the input and its answer alone.
     *
     * @param answer to the input
     * @throws IllegalArgumentException where no input can be made of that answer
     */
    List<I> furtherInputs(I input, O answer);

    /**
     * The answer that breaks it; empty where it holds.
     *
     * @param first the input and its answer
     * @param beside the further inputs with theirs, in order
     * @param alike tells whether two answers to an input are the same to the tolerance
     */
    Optional<Broken<I, O>> broken(
            AnsweredInput<I, O> first, List<AnsweredInput<I, O>> beside, Equivalence<I, O> alike);

    /** An input, and what a method answered. */
    record AnsweredInput<I, O>(I input, O output) {}

    /**
     * An answer that does not fit the others.
     *
     * @param wanted what it would be if it fitted them; empty where that cannot be told
     * @param message what is told then
     */
    record Broken<I, O>(AnsweredInput<I, O> answered, Optional<O> wanted, Message message) {
        public Broken(AnsweredInput<I, O> answered, O wanted) {
            this(answered, Optional.of(wanted), Message.NONE);
        }
    }

    /** Tells whether two answers to an input are the same. */
    @FunctionalInterface
    interface Equivalence<I, O> {
        boolean test(I input, O wanted, O answer);
    }

    /**
     * A change of the input that changes the answer in a known way.
     *
     * @param input made of the first
     * @param answer to it, made of the first input and its answer
     */
    record InputChange<I, O>(UnaryOperator<I> input, BiFunction<I, O, O> answer) {}

    /** The relation that each of these changes changes the answer as it says. */
    static <I, O> Relation<I, O> changed(List<InputChange<I, O>> changes) {
        return new Relation<>() {
            @Override
            public List<I> furtherInputs(I input, O answer) {
                return changes.stream().map(one -> one.input().apply(input)).toList();
            }

            @Override
            public Optional<Broken<I, O>> broken(
                    AnsweredInput<I, O> first,
                    List<AnsweredInput<I, O>> beside,
                    Equivalence<I, O> alike) {
                for (int i = 0; i < changes.size(); i++) {
                    O wanted = changes.get(i).answer().apply(first.input(), first.output());
                    AnsweredInput<I, O> other = beside.get(i);
                    if (!alike.test(other.input(), wanted, other.output()))
                        return Optional.of(new Broken<>(other, wanted));
                }
                return Optional.empty();
            }
        };
    }

    /** A relation of one change. */
    static <I, O> Relation<I, O> changed(UnaryOperator<I> input, BiFunction<I, O, O> answer) {
        return changed(List.of(new InputChange<>(input, answer)));
    }

    /**
     * The relation that the answer to an input made of the first answer is known by both.
     *
     * @param next makes it of the input and its answer
     * @param wanted the answer to it, made of the first input and its answer
     */
    static <I, O> Relation<I, O> followed(BiFunction<I, O, I> next, BiFunction<I, O, O> wanted) {
        return new Relation<>() {
            @Override
            public List<I> furtherInputs(I input, O answer) {
                return List.of(next.apply(input, answer));
            }

            @Override
            public Optional<Broken<I, O>> broken(
                    AnsweredInput<I, O> first,
                    List<AnsweredInput<I, O>> beside,
                    Equivalence<I, O> alike) {
                O known = wanted.apply(first.input(), first.output());
                AnsweredInput<I, O> other = beside.get(0);
                return alike.test(other.input(), known, other.output())
                        ? Optional.empty()
                        : Optional.of(new Broken<>(other, known));
            }
        };
    }

    /**
     * The relation that an answer is what is made of it and its input, such as itself mirrored.
     *
     * @param wanted made of input and answer; the answer itself where it is as it should be
     */
    static <I, O> Relation<I, O> kept(BiFunction<I, O, O> wanted) {
        return new Relation<>() {
            @Override
            public List<I> furtherInputs(I input, O answer) {
                return List.of();
            }

            @Override
            public Optional<Broken<I, O>> broken(
                    AnsweredInput<I, O> first,
                    List<AnsweredInput<I, O>> beside,
                    Equivalence<I, O> alike) {
                O known = wanted.apply(first.input(), first.output());
                return alike.test(first.input(), known, first.output())
                        ? Optional.empty()
                        : Optional.of(new Broken<>(first, known));
            }
        };
    }
}
