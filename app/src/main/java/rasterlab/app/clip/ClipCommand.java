package rasterlab.app.clip;

import java.io.IOException;
import java.util.List;
import rasterlab.app.canvas.lab.CommandInput;
import rasterlab.app.canvas.method.OwnWords;
import rasterlab.app.clip.scene.ClipScene;
import rasterlab.app.clip.scene.PlaneFigures;
import rasterlab.app.clip.scene.PlaneSegment;
import rasterlab.app.clip.scene.PolygonClipScene;
import rasterlab.app.clip.scene.SegmentScene;
import rasterlab.app.clip.scene.ShownWindow;
import rasterlab.app.clip.scene.SpaceSegment;
import rasterlab.app.clip.scene.VolumeScene;
import rasterlab.engine.format.ValueSink;

/**
 * The shell command that clips what the lab shows. Its window may be one that no input of the topic
 * has, such as a polygon around segments, so the fields are written one by one.
 */
final class ClipCommand {
    private ClipCommand() {}

    static String of(ClipScene scene) {
        return "echo '%s' | ./lab run %s %s"
                .formatted(
                        CommandInput.signed(out -> write(scene, out)),
                        scene.mode().topic(),
                        OwnWords.known(scene.method(), scene.comparison(), scene.mode().topic()));
    }

    private static void write(ClipScene scene, ValueSink out) throws IOException {
        if (scene instanceof SegmentScene shown) {
            write(shown.window(), out);
            write(shown.segments().stream().map(PlaneSegment::ends).toList(), out);
        } else if (scene instanceof PolygonClipScene polygon) {
            write(polygon.window(), out);
            out.points("polygon", PlaneFigures.xy(polygon.subject()), 2);
        } else {
            var volume = (VolumeScene) scene;
            out.number("zmin", volume.zmin());
            write(volume.segments().stream().map(SpaceSegment::ends).toList(), out);
        }
    }

    private static void write(ShownWindow window, ValueSink out) throws IOException {
        if (window.upright()) out.numbers("window", window.rectangle().sides());
        else out.points("window", window.xy(), 2);
    }

    private static void write(List<double[]> segments, ValueSink out) throws IOException {
        out.name("segments");
        out.startArray();
        for (double[] ends : segments) out.numbers(ends);
        out.endArray();
    }
}
