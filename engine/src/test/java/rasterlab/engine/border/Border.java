package rasterlab.engine.border;

import java.util.function.BiPredicate;
import java.util.function.Function;
import rasterlab.engine.study.Topic;

/**
 * How an input of one topic is made of border numbers, and which refusals its methods may answer
 * with.
 *
 * @param input makes an input; an IllegalArgumentException says that there is none of these numbers
 * @param refusals whether a refusal is one that the method's text or the contract states
 * @param promise what the contract promises of an answer beside what the topic compares
 * @param excuse whether an answer that differs does so only where the topic says that it may
 * @param most items after which an answer may be cut, where all methods send them in one order
 * @param share of the full number of inputs, for topics whose reference is slow; 1 for all
 */
record Border<C, I, O>(
        Topic<C, I, O> topic,
        Function<Draws, I> input,
        Refusals<I> refusals,
        BiPredicate<I, O> promise,
        Excuse<I, O> excuse,
        int most,
        double share) {

    /** Judges refusals. */
    @FunctionalInterface
    interface Refusals<I> {
        /**
         * Whether the method may refuse this input in these words.
         *
         * @param message of the IllegalArgumentException
         */
        boolean allowed(String method, I input, String message);
    }

    /** Judges answers that are not those of the reference. */
    @FunctionalInterface
    interface Excuse<I, O> {
        /** Whether the answer differs only where rounding may decide. */
        boolean allows(I input, O exact, O actual);
    }

    /** No method may refuse anything. */
    static <C, I, O> Border<C, I, O> of(Topic<C, I, O> topic, Function<Draws, I> input) {
        return of(topic, input, (method, any, message) -> false);
    }

    static <C, I, O> Border<C, I, O> of(
            Topic<C, I, O> topic, Function<Draws, I> input, Refusals<I> refusals) {
        return new Border<>(
                topic,
                input,
                refusals,
                (any, answer) -> true,
                (any, exact, actual) -> false,
                topic.mostItems(),
                1);
    }

    /** This border with fewer inputs. */
    Border<C, I, O> slow(double share) {
        return new Border<>(topic, input, refusals, promise, excuse, most, share);
    }

    /** This border with answers cut after so many items. */
    Border<C, I, O> cut(int most) {
        return new Border<>(topic, input, refusals, promise, excuse, most, share);
    }

    /** This border with a promise that each answer has to keep. */
    Border<C, I, O> promising(BiPredicate<I, O> promise) {
        return new Border<>(topic, input, refusals, promise, excuse, most, share);
    }

    /** This border with places where answers may differ. */
    Border<C, I, O> excusing(Excuse<I, O> excuse) {
        return new Border<>(topic, input, refusals, promise, excuse, most, share);
    }

    @Override
    public String toString() {
        return topic.name();
    }
}
