package rasterlab.exercises.line;

import java.util.Optional;
import java.util.Set;
import rasterlab.contract.LineRasterizer;
import rasterlab.engine.line.LineTopic;
import rasterlab.engine.line.Segment;
import rasterlab.engine.raster.Pixel;
import rasterlab.exercises.pixels.PixelPath;
import rasterlab.exercises.pixels.PixelsByTopic;
import rasterlab.exercises.score.Message;

/** Grades the topic {@code line}: each call draws one segment. */
public final class LineGrading extends PixelsByTopic<LineRasterizer, Segment> {
    public LineGrading() {
        super(new LineTopic(), new PlainBresenham());
    }

    @Override
    protected PixelPath path(Segment segment) {
        return new LinePath(segment);
    }

    /** {@inheritDoc} Known without drawing them: the longest segment has 2³² pixels. */
    @Override
    protected long items(Segment segment) {
        return segment.steps() + 1;
    }

    @Override
    protected Set<String> traits(Segment segment) {
        return LineTraits.of(segment);
    }

    @Override
    protected Message example(Segment segment) {
        return Message.of(
                "line.example",
                new Pixel(segment.x0(), segment.y0()),
                new Pixel(segment.x1(), segment.y1()));
    }

    @Override
    protected Optional<String> method() {
        return Optional.of("bresenham");
    }
}
