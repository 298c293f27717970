package rasterlab.engine.circle;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import rasterlab.engine.format.Field;
import rasterlab.engine.format.FieldKind;
import rasterlab.engine.format.RecordedSteps;
import rasterlab.engine.format.Shape;
import rasterlab.engine.format.ValueSink;
import rasterlab.engine.format.Written;
import rasterlab.engine.raster.AnsweredPixels;
import rasterlab.engine.raster.PixelRecording;
import rasterlab.engine.raster.PixelWindow;
import rasterlab.engine.study.Call;
import rasterlab.engine.study.Format;

/**
 * Formats of circles and ellipses have this in common: {@code center}; {@code pixels} out.
 *
 * @param <C> the contract that methods implement
 * @param <I> one input
 */
abstract class ArcFormat<C, I> extends Format<C, I, PixelRecording> {
    static final Field<int[]> CENTER =
            Field.required("center", Shape.wholes(2)).as(FieldKind.CENTER).in("pixels");

    private final ArcTopic<C, I> topic;
    private final AnsweredPixels.FigureName figure;

    ArcFormat(ArcTopic<C, I> topic, AnsweredPixels.FigureName figure) {
        super(topic);
        this.topic = topic;
        this.figure = figure;
    }

    @Override
    public final List<Field<?>> answer() {
        return List.of(AnsweredPixels.FIELD);
    }

    @Override
    public final String answers() {
        return """
            {"pixels":[[x,y],...]}""";
    }

    @Override
    public final void write(I input, PixelRecording output, ValueSink out) throws IOException {
        AnsweredPixels.write(output, out);
    }

    /** The number of pixels that the figure is known to have at most. */
    abstract long mostPixels(I input);

    @Override
    protected final PixelRecording recorded(Call<C> call, I input) {
        long most = topic.mostBeforeEndless(mostPixels(input));
        var pixels = new AnsweredPixels(call.name(), figure, PixelWindow.EVERYTHING, most);
        topic.draw(call.method(), input, pixels);
        return pixels.kept();
    }

    /** A pixel counted from the centre, with the value by which the next one is chosen. */
    private record Step(int u, int v, double decision) implements Written {
        @Override
        public void write(ValueSink out) throws IOException {
            out.whole("u", u);
            out.whole("v", v);
            out.number("decision", decision);
        }
    }

    static RecordedSteps walked(String decision, ArcWalk walk) {
        var steps = new ArrayList<Step>();
        while (walk.advance()) steps.add(new Step(walk.u(), walk.v(), walk.decision()));
        return RecordedSteps.deciding(decision, steps);
    }
}
