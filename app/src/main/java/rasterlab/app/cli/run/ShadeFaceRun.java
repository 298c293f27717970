package rasterlab.app.cli.run;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import rasterlab.app.cli.run.json.Given;
import rasterlab.app.cli.run.json.JsonField;
import rasterlab.app.cli.run.json.JsonNumbers;
import rasterlab.app.cli.run.json.StrictJson;
import rasterlab.contract.FaceShader;
import rasterlab.contract.LitFace;
import rasterlab.engine.light.face.FacePoints;
import rasterlab.engine.light.face.FaceTopic;
import rasterlab.engine.light.face.SteppedFace;
import rasterlab.engine.study.Topic;

/** Topic {@code shade-face}: a lit triangle and points of it; {@code intensity} of each out. */
final class ShadeFaceRun implements TopicRun {
    private static final JsonField<double[]> CORNERS = three("corners");
    private static final JsonField<double[]> NORMALS = three("normals");
    private static final JsonField<double[]> LAMP = LightJson.vector("lamp");
    private static final JsonField<double[]> EYE = LightJson.vector("eye");
    private static final JsonField<double[]> POINTS = PointJson.points(3);

    private final Topic<FaceShader, FacePoints, double[]> topic = new FaceTopic();
    private final Watch watch;

    /**
     * @param watch gives up a method that does not end
     */
    ShadeFaceRun(Watch watch) {
        this.watch = watch;
    }

    private static JsonField<double[]> three(String name) {
        return JsonField.required(name, json -> json.points(3, 3, 3));
    }

    @Override
    public Topic<?, ?, ?> topic() {
        return topic;
    }

    @Override
    public Form form() {
        return new Form(
                """
                {"corners":[[x,y,z],[x,y,z],[x,y,z]], "normals":[[x,y,z],...], "lamp":[x,y,z], \
                "eye":[x,y,z], "material":M, "light":L, "global-ambient":C, "points":[[a,b,c],...]}, \
                a point by its shares of the corners, light and global-ambient being optional;"""
                        + " "
                        + LightJson.FORM,
                """
                {"intensity":[[r,g,b],...]}""");
    }

    @Override
    public Answer answer(String method, byte[] text, int length, boolean steps) {
        FacePoints points =
                points(
                        StrictJson.object(
                                text,
                                length,
                                CORNERS,
                                NORMALS,
                                LAMP,
                                EYE,
                                LightJson.MATERIAL,
                                LightJson.LIGHT,
                                LightJson.GLOBAL_AMBIENT,
                                POINTS));
        FaceShader shader = topic.method(method).implementation();
        double[] shades = watch.call(method, () -> topic.record(shader, points, Integer.MAX_VALUE));
        List<Evaluation> walk =
                steps ? watch.call(method, () -> evaluations(method, shader, points)) : List.of();
        return json -> {
            json.writeFieldName("intensity");
            JsonNumbers.writePoints(json, shades, 3);
            if (steps) Steps.write(json, walk, ShadeFaceRun::write);
        };
    }

    /** The formula once. */
    private record Evaluation(double[] place, double[] normal, double[] intensity) {}

    private static List<Evaluation> evaluations(
            String method, FaceShader shader, FacePoints points) {
        SteppedFace stepped = Steps.of(method, shader, SteppedFace.class);
        List<Evaluation> all = new ArrayList<>();
        stepped.shade(
                points.face(),
                points.weights(),
                (place, normal, intensity) ->
                        Steps.add(
                                all,
                                new Evaluation(place.clone(), normal.clone(), intensity.clone())));
        return all;
    }

    private static void write(JsonGenerator json, Evaluation step) throws IOException {
        json.writeStringField("step", "formula");
        json.writeFieldName("place");
        JsonNumbers.write(json, step.place);
        json.writeFieldName("normal");
        JsonNumbers.write(json, step.normal);
        json.writeFieldName("intensity");
        JsonNumbers.write(json, step.intensity);
    }

    private static FacePoints points(Given given) {
        try {
            var face =
                    new LitFace(
                            given.get(CORNERS),
                            given.get(NORMALS),
                            given.get(LAMP),
                            given.get(EYE),
                            given.get(LightJson.MATERIAL),
                            LightJson.light(given),
                            LightJson.globalAmbient(given));
            return new FacePoints(face, given.get(POINTS));
        } catch (IllegalArgumentException e) {
            throw EngineRefusal.complaint(e);
        }
    }
}
