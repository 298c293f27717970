package rasterlab.exercises;

import java.io.DataOutputStream;
import java.io.IOException;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import rasterlab.engine.raster.Plotted;
import rasterlab.exercises.Exercise.Case;
import rasterlab.exercises.Exercise.Tolerance;
import rasterlab.exercises.score.Answer;
import rasterlab.exercises.score.Finding;
import rasterlab.exercises.score.Message;

/**
 * All that grading has to know of one topic: what a student implements, how a case is read, handed
 * to the child and judged, and what speed is measured on.
 */
public interface TopicGrading {
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
    List<Call> calls(Case one, Tolerance tolerance, long seed);

    /** Codes of the mistakes that this topic can tell, which a group of cases may claim. */
    Set<String> mistakes();

    /** The right method that a student's speed is held against. */
    Class<?> reference();

    /** Something for the reference to draw before it is timed. */
    Call warmUp();

    /**
     * Inputs to time a method on.
     *
     * @param wrongOn traits of the inputs on which it was wrong for a reason that no points were
     *     lost for: as far as possible it is not timed on the like
     */
    Timings timings(Random random, Collection<Set<String>> wrongOn);

    /** What a child is asked. */
    interface Task {
        /** One of {@link rasterlab.exercises.child.Wire}. */
        int operation();

        /** Writes what the child reads after the operation. */
        void writeTo(DataOutputStream out) throws IOException;
    }

    /** One call of the student's method. */
    interface Call extends Task {
        /** The method is stopped beyond. */
        int mostPixels();

        /** The whole finding, with pictures. */
        Finding judge(Answer answer);

        /** The same at less cost: verdict and causes alone count. */
        Finding check(Answer answer);

        /**
         * What distinguishes this input from others, as codes of texts {@code where.CODE}: a cause
         * may be found on such inputs only.
         */
        Set<String> traits();

        /** The input in words, as an example of where a cause is seen. */
        Message example();

        /** The input as a scene file that the lab opens. */
        default String scene() {
            return scene(Optional.empty());
        }

        /**
         * The same with what a student's method plotted, which the lab shows beside the right one.
         */
        String scene(Optional<Plotted> drawn);
    }

    /** Makes inputs to time a method on. */
    interface Timings {
        /** New ones, unlike all before. */
        Timing next();
    }

    /** A batch of inputs that are drawn into a sink which sums up. */
    interface Timing extends Task {
        /** Number of pixels of the right answers. */
        long count();

        /**
         * The mistakes that explain what was drawn: none for the right answer.
         *
         * @param count number of pixels that were drawn
         * @param sum of them
         * @return their codes; empty where nothing that is known explains it
         */
        Optional<Set<String>> mistakes(long count, long sum);
    }
}
