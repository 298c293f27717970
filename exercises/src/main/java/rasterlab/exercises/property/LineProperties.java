package rasterlab.exercises.property;

import java.math.BigInteger;
import java.util.ArrayList;
import java.util.List;
import rasterlab.engine.line.Segment;
import rasterlab.engine.raster.PixelRecording;
import rasterlab.exercises.property.Relation.InputChange;

/**
 * Properties of segments in pixels. All assume that no tie decides, since either of its pixels may
 * be right: the exact line passes midway between two pixels nowhere.
 */
final class LineProperties {
    private static final int RIGHT = 61;
    private static final int UP = -37;

    static final List<Property<Segment, PixelRecording>> ALL =
            List.of(
                    line("reversal", Relation.changed(Segment::reversed, LineProperties::backward)),
                    line(
                            "translation",
                            Relation.changed(LineProperties::moved, LineProperties::moved)),
                    line("octant-symmetry", Relation.changed(symmetries())));

    private LineProperties() {}

    private static Property<Segment, PixelRecording> line(
            String name, Relation<Segment, PixelRecording> relation) {
        return new Property<>("line", name, LineProperties::hasNoTie, relation);
    }

    /**
     * Whether the line of n steps along and m across has no k with the rest of k·m / n one half.
     */
    static boolean hasNoTie(Segment segment) {
        long n = segment.steps();
        long across =
                Math.min(
                        Math.abs((long) segment.x1() - segment.x0()),
                        Math.abs((long) segment.y1() - segment.y0()));
        if (across == 0) return true;
        long common = BigInteger.valueOf(n).gcd(BigInteger.valueOf(across)).longValueExact();
        return n / common % 2 != 0;
    }

    private static PixelRecording backward(Segment segment, PixelRecording pixels) {
        PixelRecording turned = new PixelRecording(Math.max(1, pixels.size()));
        for (int i = pixels.size() - 1; i >= 0; i--) turned.plot(pixels.x(i), pixels.y(i));
        return turned;
    }

    private static Segment moved(Segment one) {
        return new Segment(
                one.x0() + RIGHT, one.y0() + UP, one.x1() + RIGHT, one.y1() + UP, one.window());
    }

    private static PixelRecording moved(Segment segment, PixelRecording pixels) {
        return Symmetry.changed(pixels, (x, y) -> new int[] {x + RIGHT, y + UP});
    }

    /**
     * The start stays; the rest is mirrored in the seven ways in which octants go over into one
     * another.
     */
    private static List<InputChange<Segment, PixelRecording>> symmetries() {
        List<InputChange<Segment, PixelRecording>> changes = new ArrayList<>();
        for (Symmetry one : Symmetry.OF_OCTANTS)
            changes.add(
                    new InputChange<>(
                            segment -> {
                                int[] end =
                                        one.of(
                                                segment.x0(),
                                                segment.y0(),
                                                segment.x1(),
                                                segment.y1());
                                return new Segment(
                                        segment.x0(),
                                        segment.y0(),
                                        end[0],
                                        end[1],
                                        segment.window());
                            },
                            (segment, pixels) ->
                                    Symmetry.changed(
                                            pixels,
                                            (x, y) -> one.of(segment.x0(), segment.y0(), x, y))));
        return changes;
    }
}
