package rasterlab.app.cli.run;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import rasterlab.app.cli.run.json.JsonNumbers;
import rasterlab.engine.circle.ArcWalk;
import rasterlab.engine.raster.PixelRecording;

/**
 * The pixels of a circle or an ellipse, and its walk where one was asked for.
 *
 * @param decision what the walk's decision value is; null where no walk was asked for
 */
record ArcAnswer(PixelRecording pixels, String decision, List<Step> steps)
        implements TopicRun.Answer {
    /** A pixel counted from the centre, with the value by which the next one is chosen. */
    private record Step(int u, int v, double decision) {
        void write(JsonGenerator json) throws IOException {
            json.writeNumberField("u", u);
            json.writeNumberField("v", v);
            JsonNumbers.writeField(json, "decision", decision);
        }
    }

    static ArcAnswer of(PixelRecording pixels) {
        return new ArcAnswer(pixels, null, List.of());
    }

    static ArcAnswer of(PixelRecording pixels, String decision, ArcWalk walk) {
        var steps = new ArrayList<Step>();
        while (walk.advance()) steps.add(new Step(walk.u(), walk.v(), walk.decision()));
        return new ArcAnswer(pixels, decision, steps);
    }

    @Override
    public void write(JsonGenerator json) throws IOException {
        PixelJson.write(json, pixels);
        if (decision != null) Steps.write(json, decision, steps, (out, step) -> step.write(out));
    }
}
