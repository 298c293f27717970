package rasterlab.exercises.graded;

import java.util.List;
import java.util.function.Function;
import java.util.stream.Stream;
import rasterlab.contract.Curve;
import rasterlab.contract.CurveEvaluator;
import rasterlab.contract.CurveFlattener;
import rasterlab.contract.CurvePoints;
import rasterlab.contract.CurveTracer;
import rasterlab.contract.LineRasterizer;
import rasterlab.contract.Pixels;
import rasterlab.contract.WindowedLineRasterizer;
import rasterlab.engine.study.Topic;

/**
 * A part of a topic that an exercise may ask for by a smaller contract: the topic's inputs, methods
 * and exact answers serve as they are. A method of the smaller contract refuses what lies beyond.
 *
 * @param contract what a student implements
 * @param full the contract of the topic
 * @param widened makes a method of the full contract of one that does the part
 */
public record TopicPart<P, C>(Class<P> contract, Class<C> full, Function<P, C> widened) {
    private static final List<TopicPart<?, ?>> ALL =
            List.of(
                    new TopicPart<>(CurveEvaluator.class, CurveTracer.class, Evaluating::new),
                    new TopicPart<>(CurveFlattener.class, CurveTracer.class, Flattening::new),
                    new TopicPart<>(
                            WindowedLineRasterizer.class, LineRasterizer.class, InWindow::new));

    /** The parts that exercises may ask for. */
    public static List<TopicPart<?, ?>> all() {
        return ALL;
    }

    /** The parts of a topic: those whose full contract is its own. */
    public static Stream<TopicPart<?, ?>> of(Topic<?, ?, ?> topic) {
        return ALL.stream().filter(one -> one.full.equals(topic.contract()));
    }

    /** The contract's name without its package. */
    public String name() {
        return contract.getSimpleName();
    }

    /** A method of the full contract: the topic's own ones are already. */
    C whole(Object method) {
        return full.isInstance(method) ? full.cast(method) : widened.apply(contract.cast(method));
    }

    private static IllegalArgumentException beyond(String what) {
        return new IllegalArgumentException("the contract has no " + what);
    }

    private record Evaluating(CurveEvaluator part) implements CurveTracer {
        @Override
        public void at(Curve curve, double[] t, CurvePoints out) {
            part.at(curve, t, out);
        }

        @Override
        public void flatten(Curve curve, double flatness, CurvePoints out) {
            throw beyond("flatness");
        }
    }

    private record Flattening(CurveFlattener part) implements CurveTracer {
        @Override
        public void at(Curve curve, double[] t, CurvePoints out) {
            throw beyond("points at given t");
        }

        @Override
        public void flatten(Curve curve, double flatness, CurvePoints out) {
            part.flatten(curve, flatness, out);
        }
    }

    private record InWindow(WindowedLineRasterizer part)
            implements LineRasterizer, WindowedLineRasterizer {
        @Override
        public void draw(int x0, int y0, int x1, int y1, Pixels out) {
            throw beyond("segment without a window");
        }

        @Override
        public void draw(
                int x0,
                int y0,
                int x1,
                int y1,
                int xmin,
                int ymin,
                int xmax,
                int ymax,
                Pixels out) {
            part.draw(x0, y0, x1, y1, xmin, ymin, xmax, ymax, out);
        }
    }
}
