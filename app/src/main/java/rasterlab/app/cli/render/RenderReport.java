package rasterlab.app.cli.render;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import rasterlab.app.plan.CountedWork;
import rasterlab.app.plan.PlanReport;
import rasterlab.contract.Reflection;
import rasterlab.engine.light.LightTerm;
import rasterlab.engine.pipeline.Choice;
import rasterlab.engine.pipeline.Look;
import rasterlab.engine.pipeline.RenderRequest;
import rasterlab.engine.pipeline.Renderer;
import rasterlab.engine.pipeline.ShadingMethod;
import rasterlab.engine.pipeline.paint.Sides;
import rasterlab.engine.plan.Plan;
import rasterlab.engine.plan.PlanDecision;
import rasterlab.engine.plan.StageTimes;
import rasterlab.engine.raster.PictureDifference;
import rasterlab.engine.visibility.ClipPlane;
import rasterlab.engine.visibility.VisibilityWork;

/**
 * The report that {@code ./lab render} prints.
 *
 * @param plan by which it was drawn, if a tolerance was given
 * @param shading chosen by a bound, if levels alone were given
 * @param milliseconds wall time of the rendering alone
 * @param work what the visibility method counted
 * @param counted the picture's work, stage by stage, where it is counted
 * @param times measured stage by stage, if asked for
 * @param out where the picture was written; null if it was not
 * @param other what it was compared with; null if with nothing
 * @param errors of the cheaper shadings, if asked for
 */
record RenderReport(
        RenderRequest request,
        Optional<Plan> plan,
        Optional<Choice> shading,
        double milliseconds,
        Optional<VisibilityWork> work,
        Optional<CountedWork> counted,
        Optional<StageTimes> times,
        Path out,
        Path other,
        Optional<PictureDifference> difference,
        Optional<ShadingErrors> errors) {

    /** Writes one JSON object and a line end. */
    void write(OutputStream stream) throws IOException {
        try (JsonGenerator json = new JsonFactory().createGenerator(stream)) {
            json.disable(JsonGenerator.Feature.AUTO_CLOSE_TARGET).useDefaultPrettyPrinter();
            json.writeStartObject();
            writeRequest(json);
            json.writeNumberField("milliseconds", milliseconds);
            if (work.isPresent()) writeWork(json, work.get());
            if (counted.isPresent()) counted.get().write(json);
            if (times.isPresent()) CountedWork.write(json, times.get());
            if (plan.isPresent()) PlanReport.writePlan(json, plan.get());
            if (out != null) json.writeStringField("out", out.toString());
            if (difference.isPresent()) writeDifference(json, difference.get());
            if (errors.isPresent()) errors.get().write(json);
            json.writeEndObject();
            json.writeRaw('\n');
        }
    }

    private static void writeWork(JsonGenerator json, VisibilityWork work) throws IOException {
        json.writeObjectFieldStart("work");
        json.writeNumberField("comparisons", work.comparisons());
        json.writeNumberField("depthTests", work.depthTests());
        json.writeNumberField("pixelsWritten", work.pixelsWritten());
        json.writeNumberField("splits", work.splits());
        json.writeEndObject();
    }

    private void writeRequest(JsonGenerator json) throws IOException {
        json.writeStringField("scene", request.scene().name());
        writeChoice(json, "visibility", Renderer.visibility(request));
        writeChoice(json, "shading", shading.orElseGet(() -> Renderer.shading(request)));
        writeChoice(json, "texture", Renderer.texture(request));
        writeView(json);
        writeLook(json, request.look());
        json.writeNumberField("width", request.width());
        json.writeNumberField("height", request.height());
    }

    /**
     * Writes the method that is used under its own name, and the reason under the name with {@code
     * Because}.
     */
    private void writeChoice(JsonGenerator json, String name, Choice choice) throws IOException {
        json.writeStringField(name, choice.chosen());
        String reason =
                decided(name)
                        .map(decision -> "plan: " + decision.reason().english())
                        .orElse(choice.reason());
        json.writeStringField(name + "Because", reason);
    }

    private Optional<PlanDecision> decided(String subject) {
        return plan.stream()
                .flatMap(one -> one.decisions().stream())
                .filter(one -> one.subject().equals(subject))
                .findFirst();
    }

    /** The terms of light that are drawn: a plan leaves out those that add nothing. */
    private Set<LightTerm> terms(Look look) {
        var terms = new TreeSet<>(look.terms());
        if (request.scene().light().model().reflection() == Reflection.LAMBERT
                && decided("terms").isPresent()) terms.remove(LightTerm.SPECULAR);
        return terms;
    }

    private void writeView(JsonGenerator json) throws IOException {
        json.writeStringField("projection", request.projection().code());
        json.writeObjectFieldStart("camera");
        json.writeNumberField("theta", request.camera().thetaRadians());
        json.writeNumberField("phi", request.camera().phiRadians());
        json.writeNumberField("rho", request.camera().rho());
        json.writeBooleanField("anglesUsed", request.projection().turnsWithCamera());
        json.writeEndObject();
        writeBound(json, "near", request.depth().near());
        writeBound(json, "far", request.depth().far());
        json.writeNumberField("pictureScale", request.scene().pictureScale());
    }

    /** JSON has no infinity: null where nothing is cut off. */
    private static void writeBound(JsonGenerator json, String name, double depth)
            throws IOException {
        if (Double.isInfinite(depth)) json.writeNullField(name);
        else json.writeNumberField(name, depth);
    }

    private void writeLook(JsonGenerator json, Look look) throws IOException {
        json.writeArrayFieldStart("terms");
        for (LightTerm term : terms(look)) json.writeString(term.code());
        json.writeEndArray();
        if (look.sides() != Sides.SCENE)
            json.writeBooleanField("twoSided", look.sides() == Sides.TWO);
        json.writeStringField("cull", look.cull().code());
        json.writeBooleanField("outline", look.outline());
        if (look.shading() == ShadingMethod.WIRE) {
            json.writeStringField("hiddenLines", look.wire().hidden().code());
            json.writeNumberField("crease", look.wire().creaseDegrees());
        }
        if (look.cue().isPresent()) json.writeNumberField("depthCue", look.cue().get().strength());
        if (!look.clipPlanes().isEmpty()) writePlanes(json, look.clipPlanes());
        if (look.stereo().isEmpty()) return;
        json.writeStringField("stereo", look.stereo().get().kind().code());
        json.writeNumberField("eyes", look.stereo().get().separation(request.camera().rho()));
    }

    private static void writePlanes(JsonGenerator json, List<ClipPlane> planes) throws IOException {
        json.writeArrayFieldStart("clipPlanes");
        for (ClipPlane p : planes) json.writeArray(new double[] {p.a(), p.b(), p.c(), p.d()}, 0, 4);
        json.writeEndArray();
    }

    private void writeDifference(JsonGenerator json, PictureDifference found) throws IOException {
        json.writeObjectFieldStart("diff");
        json.writeStringField("with", other.toString());
        writeCounts(json, found);
        json.writeEndObject();
    }

    static void writeCounts(JsonGenerator json, PictureDifference found) throws IOException {
        json.writeNumberField("wrongPixels", found.wrongPixels());
        json.writeNumberField("wrongByMoreThan2Levels", found.plainlyWrongPixels());
        json.writeNumberField("pixels", found.pixels());
        json.writeNumberField("share", found.share());
        json.writeNumberField("largestLevelDifference", found.largestLevelDifference());
    }
}
