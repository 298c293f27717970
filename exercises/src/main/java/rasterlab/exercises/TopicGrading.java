package rasterlab.exercises;

import com.fasterxml.jackson.databind.JsonNode;
import java.time.Duration;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.Random;
import java.util.Set;
import java.util.stream.Stream;
import rasterlab.engine.study.LimitReached;
import rasterlab.exercises.Exercise.Case;
import rasterlab.exercises.Exercise.ExerciseTolerance;
import rasterlab.exercises.score.Answer;
import rasterlab.exercises.score.Cause;
import rasterlab.exercises.score.Finding;
import rasterlab.exercises.score.Message;

/**
 * All that grading has to know of one topic: what a student implements, how a case is read, handed
 * to the child and judged, and what speed is measured on.
 */
public interface TopicGrading {
    /** The trait of a call on several inputs, of which one may have gone wrong. */
    String SEVERAL = "several";

    /** The engine's name of the topic. */
    String name();

    /** The interface that a student's class implements. */
    Class<?> contract();

    /**
     * The calls that make up a case, to be tried one after the other; at least one.
     *
     * @param seed draws those of a generated case
     * @throws CatalogueException when the case's input is not what the topic reads
     */
    List<GradedCall> calls(Case one, ExerciseTolerance tolerance, long seed);

    /** Codes of the mistakes that this topic can tell, which a group of cases may claim. */
    Set<String> mistakes();

    /**
     * The right method that a student's speed is held against; empty where each exercise brings its
     * own, its model solution.
     */
    Optional<Class<?>> reference();

    /** A method of the contract that answers right, or refuses. */
    Object right();

    /**
     * A method of the topic's contract that does what a student's does.
     *
     * @param method of {@link #contract}
     */
    Object asMethod(Object method);

    /**
     * The topic's methods that are kept as right ones, in teaching order: what a student's speed
     * and error are shown beside.
     */
    Map<String, Object> classics();

    /** The unit of the topic's errors, in which an exercise may state a tolerance. */
    default Optional<String> unit() {
        return Optional.empty();
    }

    /** The methods whose answers an exercise may call the right ones; none where it may not. */
    default List<String> truths() {
        return List.of();
    }

    /**
     * The key of a text in this topic's words.
     *
     * @param key of the text about lines
     */
    default String inOwnWords(String key) {
        return key + ".any";
    }

    /**
     * Inputs to time a method on.
     *
     * @param wrongOn traits of the inputs on which it was wrong for a reason that no points were
     *     lost for: as far as possible it is not timed on the like
     */
    Timings timings(Exercise exercise, Random random, Collection<Set<String>> wrongOn);

    /**
     * A batch of given inputs, whose answers nobody judges.
     *
     * @param inputs of the topic, at least one
     */
    TimingInputs timing(List<?> inputs);

    /**
     * Limits beyond which a call is stopped.
     *
     * @param items that a sink takes
     * @param bytes of the answer
     * @param processor time of all that the call makes a method do; where it is not given, as much
     *     as the judge allows
     */
    record CallLimits(int items, int bytes, Optional<Duration> processor) {
        /** Caps the items at a number, and allows as much else as can be taken. */
        public static CallLimits ofItems(long items) {
            return new CallLimits(
                    (int) Math.min(items, Exercise.StatedLimits.MOST_ITEMS),
                    Exercise.StatedLimits.MOST_BYTES,
                    Optional.empty());
        }

        /** These limits with those that an exercise states; items become fewer at most. */
        public CallLimits within(Exercise.StatedLimits stated) {
            return new CallLimits(
                    Math.min(items, stated.items().orElse(items)),
                    stated.bytes().orElse(bytes),
                    stated.processor().or(() -> processor));
        }
    }

    /** One input, and what a method answers to it. */
    interface GradedCall {
        CallLimits caps();

        /** Number of items of the right answer, as far as it is looked at. */
        long items();

        /**
         * Has a method answer and keeps what came of it, an output of the topic.
         *
         * @param method of the contract; it may run elsewhere
         * @param most items
         * @throws LimitReached when it goes on beyond the most items; carries the output so far
         */
        Object recorded(Object method, int most);

        /** The whole finding, with pictures. */
        Finding judge(Answer answer);

        /** Checks an answer at less cost: verdict and causes alone count. */
        Finding check(Answer answer);

        /**
         * The traits of this input, as codes of texts {@code where.CODE}: a cause may be found on
         * such inputs only.
         */
        Set<String> traits();

        /**
         * Whether a known mistake would leave a right answer to this input right.
         *
         * @param mistake its code
         */
        default boolean isRightWith(String mistake) {
            return true;
        }

        /**
         * Whether a wrong answer comes by a change of the right one, as far as that can be told.
         *
         * @param change its code
         */
        default boolean comesBy(String change, Answer answer) {
            return true;
        }

        /**
         * Whether a wrong answer comes by a slip of the topic, also where a mistake of another kind
         * gives the same answer.
         *
         * @param slip its code
         */
        default boolean comesBySlip(String slip, Answer answer) {
            return false;
        }

        /**
         * The mistake of a method that does nothing, where the answer may be one of such: nothing
         * sent or changed, nothing but zeros. Empty for any other answer.
         */
        default Optional<Cause> idle(Answer answer) {
            return Optional.empty();
        }

        /**
         * The whole finding on an answer of a program that does nothing on any input, of which no
         * other mistake is told.
         */
        default Finding judgeIdle(Answer answer, Cause idle) {
            return judge(answer);
        }

        /** Whether the answer breaks the property that is asked for; false where none is. */
        default boolean breaksProperty(Answer answer) {
            return false;
        }

        /**
         * The call on the one input whose answer is not right, where several are asked for; else
         * this one.
         */
        default GradedCall inQuestion(Answer answer) {
            return this;
        }

        /**
         * How far an output is from the right one, in the topic's unit; infinite where items are
         * missing or extra, empty where no such distance is asked for.
         */
        default OptionalDouble error(Object output) {
            return OptionalDouble.empty();
        }

        /** The remark where a case holds on all its inputs; empty where there is none. */
        default Message held() {
            return Message.NONE;
        }

        /**
         * This call on smaller inputs, of which one that goes wrong too may be told in this one's
         * place; none where only this input is asked for.
         */
        default Stream<GradedCall> smaller() {
            return Stream.empty();
        }

        /** The input as {@code ./lab run} takes it. */
        JsonNode input();

        /** The right answer as {@code ./lab run} gives it. */
        JsonNode exact();

        /** The input in words, as an example of where a cause is seen. */
        Message example();

        /** The input as a scene file that the lab opens. */
        default String scene() {
            return scene(Optional.empty());
        }

        /**
         * The scene with what a student's method did where it is not right, as far as the lab shows
         * it beside the right one.
         */
        String scene(Optional<Answer> wrong);
    }

    /** Makes inputs to time a method on. */
    interface Timings {
        /** New ones, unlike all before. */
        TimingInputs next();
    }

    /** A batch of inputs to time a method on. */
    interface TimingInputs {
        /** Number of inputs. */
        int inputs();

        /**
         * Has a method answer one of the inputs and keeps what came of it.
         *
         * @param input from 0
         */
        Object recorded(int input, Object method);

        /**
         * Has a method answer one of the inputs as fast as it goes.
         *
         * @param input from 0
         * @return number of items
         */
        long spent(int input, Object method);

        /** The most items that a sink may take for an input. */
        int mostItems();

        /** Items that a sink has room for from the start, so that making more takes no time. */
        int usualItems();

        /**
         * The input whose answer is looked at itself, which the method does not know; empty where
         * the sum of all tells enough.
         */
        OptionalInt looked();

        /** A method that answers right. */
        Object right();

        /** Number of items of the right answers. */
        long count();

        /**
         * The mistakes that explain the answers: none for right ones.
         *
         * @return their codes; empty where nothing that is known explains them
         */
        Optional<Set<String>> mistakes(TimedAnswers told);
    }

    /**
     * The child's account of timed answers.
     *
     * @param count number of items
     * @param sum of them
     * @param looked the answer to the input that is looked at
     */
    record TimedAnswers(long count, long sum, Optional<Object> looked) {}
}
