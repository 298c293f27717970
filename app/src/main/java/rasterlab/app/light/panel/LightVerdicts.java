package rasterlab.app.light.panel;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import java.util.function.Supplier;
import rasterlab.app.canvas.work.LatestOnly;
import rasterlab.app.light.LightHazard;
import rasterlab.app.light.LitBody;
import rasterlab.contract.ColorConverter;
import rasterlab.contract.ColorModel;
import rasterlab.engine.color.ColorTopic;
import rasterlab.engine.color.Colors;
import rasterlab.engine.light.normals.NormalsTopic;
import rasterlab.engine.light.normals.TriangleSurface;
import rasterlab.engine.scene.Mesh;
import rasterlab.engine.study.Deviation;
import rasterlab.engine.study.HazardTrial;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Topic;
import rasterlab.engine.study.Verdict;
import rasterlab.engine.transform.Images;

/**
 * Finds in the background the verdicts of the methods that the lab lets one choose, for its own
 * hazards.
 */
final class LightVerdicts implements AutoCloseable {
    private final LatestOnly<LightVerdictRequest, Map<String, Verdict.Kind>> verdicts;

    private record LightVerdictRequest(
            Supplier<Map<String, Verdict.Kind>> finding,
            Consumer<Map<String, Verdict.Kind>> listener) {}

    /**
     * @param events runs what it is given on the one thread that is told the verdicts
     * @param onFailure told what a method threw, on any thread
     */
    LightVerdicts(Executor events, Consumer<Throwable> onFailure) {
        verdicts =
                new LatestOnly<>(
                        "verdicts of light",
                        (asked, cancelled) -> asked.finding().get(),
                        (asked, found) -> events.execute(() -> asked.listener().accept(found)),
                        onFailure);
    }

    /** Tells the verdicts that {@code finding} gives, unless others are asked for. */
    void ask(
            Supplier<Map<String, Verdict.Kind>> finding, Consumer<Map<String, Verdict.Kind>> told) {
        verdicts.ask(new LightVerdictRequest(finding, told));
    }

    /** Ends the thread. */
    @Override
    public void close() {
        verdicts.close();
    }

    /**
     * The verdicts of normals where a body is lit: right are those of its surface, and what counts
     * as near them is what topic {@code vertex-normals} says.
     */
    static Map<String, Verdict.Kind> ofNormals(LightHazard hazard) {
        LitBody body = hazard.shown().body();
        Images right = normals(body.withNormals(LitBody.OWN));
        var topic = new NormalsTopic();
        var verdicts = new LinkedHashMap<String, Verdict.Kind>();
        for (String name : LitBody.NORMALS) {
            Images found = normals(body.withNormals(name));
            Deviation off =
                    topic.compare(new TriangleSurface(new double[0], new int[0]), right, found);
            verdicts.put(name, kind(topic, off));
        }
        return verdicts;
    }

    private static Verdict.Kind kind(Topic<?, ?, ?> topic, Deviation deviation) {
        if (topic.correct(deviation)) return Verdict.Kind.EXACT;
        return topic.usable(deviation) ? Verdict.Kind.DEGRADED : Verdict.Kind.WRONG;
    }

    /** The normals of all corners. */
    private static Images normals(LitBody body) {
        Mesh mesh = body.scene().mesh();
        var normals = new double[3 * mesh.totalCorners()];
        int at = 0;
        for (int f = 0; f < mesh.faceCount(); f++)
            for (int k = 0; k < mesh.cornerCount(f); k++)
                for (int axis = 0; axis < 3; axis++) normals[at++] = mesh.cornerNormal(f, k, axis);
        return new Images(normals, 3);
    }

    /** The verdicts of topic {@code color} on one colour. */
    static Map<String, Verdict.Kind> ofColor(double[] rgb) {
        var topic = new ColorTopic();
        var color = new Colors(ColorModel.RGB, rgb);
        var verdicts = new LinkedHashMap<String, Verdict.Kind>();
        for (Method<ColorConverter> method : topic.methods())
            verdicts.put(
                    method.name(),
                    HazardTrial.tried(topic, method, color, HazardTrial.WALL_LIMIT)
                            .verdict()
                            .kind());
        return verdicts;
    }
}
