package rasterlab.exercises.property;

import java.util.Comparator;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import rasterlab.contract.FillRule;
import rasterlab.engine.circle.Circle;
import rasterlab.engine.circle.Ellipse;
import rasterlab.engine.polygon.scan.PolygonTask;
import rasterlab.engine.raster.PixelRecording;
import rasterlab.engine.raster.PixelSet;
import rasterlab.exercises.property.Relation.AnsweredInput;
import rasterlab.exercises.property.Relation.Broken;
import rasterlab.exercises.property.Relation.Equivalence;

/** Properties of figures that are a set of pixels, each once. */
final class PixelProperties {
    static final List<Property<?, PixelRecording>> ALL =
            List.of(
                    Property.<Circle, PixelRecording>always(
                            "circle",
                            "octant-symmetry",
                            Relation.kept(
                                    (circle, pixels) ->
                                            mirrored(
                                                    pixels,
                                                    Symmetry.OF_OCTANTS,
                                                    circle.centerX(),
                                                    circle.centerY()))),
                    Property.<Ellipse, PixelRecording>always(
                            "ellipse",
                            "quadrant-symmetry",
                            Relation.kept(
                                    (ellipse, pixels) ->
                                            mirrored(
                                                    pixels,
                                                    Symmetry.OF_QUADRANTS,
                                                    ellipse.centerX(),
                                                    ellipse.centerY()))),
                    new Property<PolygonTask, PixelRecording>(
                            "polygon-fill",
                            "shared-edge-once",
                            task -> task.rule() == FillRule.EVEN_ODD && task.x().length >= 4,
                            new SharedEdge()));

    private PixelProperties() {}

    /** A pixel; by rows, each from left to right. */
    private record Place(int x, int y) {
        static final Comparator<Place> BY_ROWS =
                Comparator.comparingInt(Place::y).thenComparingInt(Place::x);
    }

    private static PixelRecording recording(Set<Place> places) {
        PixelRecording all = new PixelRecording(Math.max(1, places.size()));
        for (Place one : places) all.plot(one.x(), one.y());
        return all;
    }

    private static Set<Place> places(PixelRecording pixels) {
        Set<Place> places = new LinkedHashSet<>();
        for (int i = 0; i < pixels.size(); i++) places.add(new Place(pixels.x(i), pixels.y(i)));
        return places;
    }

    /** The pixels with all their mirror images, each once. */
    private static PixelRecording mirrored(
            PixelRecording pixels, List<Symmetry> symmetries, int centerX, int centerY) {
        Set<Place> all = places(pixels);
        for (Place one : List.copyOf(all))
            for (Symmetry each : symmetries) {
                int[] at = each.of(centerX, centerY, one.x(), one.y());
                all.add(new Place(at[0], at[1]));
            }
        return recording(all);
    }

    /**
     * The relation that a polygon has the pixels that just one of its two parts has, which a
     * diagonal makes of it: by the even-odd rule its edge counts twice, once for each.
     */
    private static final class SharedEdge implements Relation<PolygonTask, PixelRecording> {
        @Override
        public List<PolygonTask> furtherInputs(PolygonTask task, PixelRecording answer) {
            int corners = task.x().length;
            int half = corners / 2;
            return List.of(part(task, 0, half), part(task, half, corners));
        }

        /** The part of a polygon from one corner to another, the last being the first again. */
        private static PolygonTask part(PolygonTask task, int from, int to) {
            double[] x = new double[to - from + 1];
            double[] y = new double[to - from + 1];
            for (int i = from; i <= to; i++) {
                x[i - from] = task.x()[i % task.x().length];
                y[i - from] = task.y()[i % task.x().length];
            }
            return new PolygonTask(x, y, task.rule(), task.width(), task.height());
        }

        @Override
        public Optional<Broken<PolygonTask, PixelRecording>> broken(
                AnsweredInput<PolygonTask, PixelRecording> whole,
                List<AnsweredInput<PolygonTask, PixelRecording>> parts,
                Equivalence<PolygonTask, PixelRecording> alike) {
            PixelSet one = PixelSet.of(parts.get(0).output());
            PixelSet other = PixelSet.of(parts.get(1).output());
            Set<Place> wanted = new TreeSet<>(Place.BY_ROWS);
            for (AnsweredInput<PolygonTask, PixelRecording> part : parts)
                for (Place each : places(part.output()))
                    if (one.contains(each.x(), each.y()) != other.contains(each.x(), each.y()))
                        wanted.add(each);
            PixelRecording joined = recording(wanted);
            return alike.test(whole.input(), joined, whole.output())
                    ? Optional.empty()
                    : Optional.of(new Broken<>(whole, joined));
        }
    }
}
