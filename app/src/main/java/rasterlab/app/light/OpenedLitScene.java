package rasterlab.app.light;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import rasterlab.app.model.ModelNotes;
import rasterlab.app.model.SceneText;
import rasterlab.app.outcome.Complaint;
import rasterlab.app.outcome.FileKind;
import rasterlab.app.outcome.FileToRead;
import rasterlab.app.outcome.WholeFile;
import rasterlab.engine.pipeline.Cull;
import rasterlab.engine.pipeline.ShadingMethod;
import rasterlab.engine.pipeline.paint.TextureMode;
import rasterlab.engine.pipeline.wire.HiddenLines;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.scene.obj.UpAxis;
import rasterlab.engine.transform.Projection;
import rasterlab.exercises.scene.SceneSetting;
import rasterlab.exercises.scene.SceneSource;
import rasterlab.exercises.scene.SceneView;
import rasterlab.exercises.scene.Settings;

/**
 * A scene file, or a model, as the lab of light shows it.
 *
 * <p>A model is a body in what light and material there are. Of a scene file, light and material
 * are the file's where lamps and substances of the lab make the same; else those of the choice
 * stay, and a note says so.
 *
 * @param choice what is shown
 * @param notes what of the file is not shown
 * @param whole whether {@code ./lab render} draws what is shown from the file
 */
public record OpenedLitScene(LightChoice choice, List<String> notes, boolean whole) {
    /**
     * A setting of a file.
     *
     * @param drawn whether the lab draws a value of it
     */
    private record Part<T>(SceneSetting<T> setting, Predicate<T> drawn) {
        static <T> Part<T> never(SceneSetting<T> setting) {
            return new Part<>(setting, value -> false);
        }

        boolean passedOver(Settings said) {
            return said.get(setting).filter(drawn.negate()).isPresent();
        }
    }

    private static final String MODEL = ".obj";

    /** The files that are opened, by the ends of their names, lower-case. */
    public static final List<String> ENDINGS = List.of(MODEL, SceneText.EXTENSION);

    private static final List<Part<?>> PARTS =
            List.of(
                    Part.never(SceneSetting.NEAR),
                    Part.never(SceneSetting.FAR),
                    Part.never(SceneSetting.CLIP_PLANES),
                    Part.never(SceneSetting.TEXTURE_IMAGE),
                    Part.never(SceneSetting.DEPTH_CUE),
                    Part.never(SceneSetting.STEREO),
                    new Part<>(
                            SceneSetting.PROJECTION, EnumSet.of(Projection.PERSPECTIVE)::contains),
                    new Part<>(SceneSetting.CULL, EnumSet.of(Cull.NONE)::contains),
                    new Part<>(SceneSetting.OUTLINE, outlined -> !outlined),
                    new Part<>(
                            SceneSetting.SHADING,
                            EnumSet.complementOf(EnumSet.of(ShadingMethod.TONE, ShadingMethod.WIRE))
                                    ::contains),
                    new Part<>(
                            SceneSetting.TEXTURE,
                            EnumSet.of(TextureMode.NONE, TextureMode.AUTO)::contains),
                    Part.never(SceneSetting.WRAP),
                    Part.never(SceneSetting.ENVIRONMENT),
                    new Part<>(
                            SceneSetting.HIDDEN_LINES, EnumSet.of(HiddenLines.REMOVED)::contains),
                    new Part<>(SceneSetting.CREASE, degrees -> degrees == 0));

    /**
     * @param before what was shown, of which stays what the file does not say
     * @throws Complaint naming the file and the place in it
     */
    static OpenedLitScene read(Path file, LightChoice before) {
        if (isModel(file)) {
            ModelNotes model = ModelNotes.read(file);
            LightChoice shown = before.with(LitBody.model(file, model.scene(), UpAxis.Y));
            return new OpenedLitScene(shown, List.of(model.notes()), false);
        }
        SceneView view = view(file);
        Settings said = view.settings();
        var notes = new ArrayList<String>();
        LightChoice next = before.with(body(file, view.source(), before.body().detail()));
        boolean inline = view.source() instanceof SceneSource.Inline;
        if (inline) next = dressed(next, view.source().scene(), notes);
        next =
                next.with(said.get(SceneSetting.CAMERA).orElse(next.camera()))
                        .withTerms(said.get(SceneSetting.TERMS).orElse(next.terms()))
                        .withTwoSides(said.get(SceneSetting.TWO_SIDED).orElse(next.twoSided()));
        Optional<Double> zoom = said.get(SceneSetting.ZOOM);
        if (zoom.isPresent()) next = zoomed(next, zoom.get(), notes);
        String passed = passedOver(said);
        if (!passed.isEmpty()) notes.add("this lab does not draw what the file says of " + passed);
        return new OpenedLitScene(next, List.copyOf(notes), inline && notes.isEmpty());
    }

    /**
     * The body of a file alone, in the light of the choice.
     *
     * @param up the axis of a model that points up
     * @throws Complaint naming the file and the place in it
     */
    static OpenedLitScene again(Path file, UpAxis up, LightChoice before) {
        LitBody body =
                isModel(file)
                        ? LitBody.model(file, ModelNotes.read(file, up).scene(), up)
                        : body(file, view(file).source(), before.body().detail());
        return new OpenedLitScene(before.with(body), List.of(), false);
    }

    /**
     * The lit model with another axis up, as its file has it now, with the choice's normals.
     *
     * @throws Complaint naming the file and the place in it
     */
    static OpenedLitScene standing(Path file, UpAxis up, LightChoice before) {
        LitBody turned = again(file, up, before).choice().body();
        LightChoice next = before.with(turned.withNormals(before.body().normals()));
        return new OpenedLitScene(next, List.of(), false);
    }

    /** The notes about the file that stand beside its picture; "" for none. */
    String notes(Path file) {
        String told = String.join("; ", notes);
        return told.isEmpty() || isModel(file) ? told : file + ": " + told;
    }

    private static boolean isModel(Path file) {
        return lowerCase(file).endsWith(MODEL);
    }

    private static String lowerCase(Path file) {
        return String.valueOf(file.getFileName()).toLowerCase(Locale.ROOT);
    }

    /**
     * The view in a file; where its name is no scene's, only what stands in a scene's place is
     * told.
     */
    private static SceneView view(Path file) {
        if (lowerCase(file).endsWith(".json")) return SceneText.view(file);
        try {
            FileToRead.requireNoPicture(file, FileKind.SCENE);
        } catch (IOException e) {
            throw Complaint.badInput(file + ": cannot be read: " + WholeFile.reason(e));
        }
        throw Complaint.badInput(
                file + ": unknown extension; allowed are " + String.join(" and ", ENDINGS));
    }

    private static LightChoice zoomed(LightChoice choice, double zoom, List<String> notes) {
        double shown = Math.max(LightChoice.SMALLEST, Math.min(LightChoice.LARGEST, zoom));
        if (shown != zoom) notes.add("zoom is %s, not the file's %s".formatted(shown, zoom));
        return choice.withZoom(shown);
    }

    private static LitBody body(Path file, SceneSource source, int detail) {
        if (source instanceof SceneSource.ByName named && LitBody.NAMES.contains(named.name())) {
            int steps = named.detail().orElse(detail);
            boolean listed = steps >= LitBody.COARSEST && steps <= LitBody.FINEST;
            var body = new LitBody(named.name(), listed ? steps : detail, LitBody.OWN);
            if (listed && named.detail().isPresent() || !body.hasDetail()) return body;
        }
        return LitBody.opened(file, source.scene());
    }

    private static LightChoice dressed(LightChoice choice, Scene scene, List<String> notes) {
        Optional<LightChoice> lit = LampsOfFile.lit(choice, scene.light());
        Optional<MaterialChoice> material = MaterialOfFile.of(scene.finishes());
        if (lit.isEmpty())
            notes.add("lights of this lab cannot shine as the file's light does; its own stay");
        if (material.isEmpty())
            notes.add("no substance of this lab is what the file's faces are of; its own stays");
        LightChoice next = lit.orElse(choice);
        return material.map(next::with).orElse(next);
    }

    private static String passedOver(Settings said) {
        return PARTS.stream()
                .filter(part -> part.passedOver(said))
                .map(part -> part.setting().field())
                .collect(Collectors.joining(", "));
    }
}
