package rasterlab.app.light;

import java.nio.file.Path;
import java.util.List;
import java.util.TreeSet;
import java.util.stream.Collectors;
import rasterlab.app.canvas.file.ShellPath;
import rasterlab.app.model.SceneText;
import rasterlab.app.outcome.Complaint;
import rasterlab.engine.light.LightTerm;
import rasterlab.engine.pipeline.Renderer;
import rasterlab.engine.pipeline.ShadingMethod;
import rasterlab.engine.pipeline.paint.TextureMode;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.transform.Projection;
import rasterlab.engine.transform.SphericalView;
import rasterlab.exercises.scene.SceneSetting;
import rasterlab.exercises.scene.SceneSource;
import rasterlab.exercises.scene.SceneView;
import rasterlab.exercises.scene.Settings;

/**
 * A scene in its light as a file, which {@code ./lab render} and the lab of hidden surfaces open.
 *
 * @param choice what was saved
 */
public record LitSceneFile(Path file, LightChoice choice) {
    /**
     * Writes the scene; takes long for many faces.
     *
     * @throws Complaint if the file cannot be written
     */
    public static LitSceneFile write(LightChoice choice, Path file) {
        Settings said =
                Settings.NONE
                        .with(SceneSetting.CAMERA, choice.camera())
                        .with(SceneSetting.PROJECTION, Projection.PERSPECTIVE)
                        .with(SceneSetting.ZOOM, choice.zoom())
                        .with(SceneSetting.VISIBILITY, Renderer.PIPELINE)
                        .with(SceneSetting.SHADING, ShadingMethod.PHONG)
                        .with(SceneSetting.TEXTURE, TextureMode.NONE)
                        .with(SceneSetting.TERMS, choice.terms());
        Scene scene = LitScene.scene(choice, choice.body().scene());
        SceneText.write(file, new SceneView(new SceneSource.Inline(scene), said));
        return new LitSceneFile(file, choice);
    }

    /** Whether the file holds what is shown now, from wherever it is seen. */
    public boolean holds(LightChoice now) {
        return choice.body().equals(now.body())
                && choice.zoom() == now.zoom()
                && choice.material().equals(now.material())
                && choice.lamps().equals(now.lamps())
                && choice.ambient() == now.ambient()
                && choice.reflection() == now.reflection()
                && choice.localViewer() == now.localViewer()
                && choice.twoSided() == now.twoSided();
    }

    /**
     * The shell commands that draw the three pictures from the file, a line each.
     *
     * @param now held by the file
     * @param width of a picture, in pixels
     * @param height of a picture, in pixels
     */
    public String commands(LightChoice now, int width, int height) {
        return LightFrame.SHADINGS.stream()
                .map(shading -> command(now, shading, width, height))
                .collect(Collectors.joining("\n"));
    }

    private String command(LightChoice now, ShadingMethod shading, int width, int height) {
        SphericalView eye = now.camera();
        String terms =
                now.terms().equals(LightTerm.all())
                        ? ""
                        : " --terms "
                                + new TreeSet<>(now.terms())
                                        .stream()
                                                .map(LightTerm::code)
                                                .collect(Collectors.joining(","));
        return String.join(
                " ",
                List.of(
                        "./lab render",
                        ShellPath.quoted(file),
                        "--scene-only",
                        "--visibility",
                        Renderer.PIPELINE,
                        "--shading",
                        shading.code(),
                        now.twoSided() ? "--two-sided" : "--no-two-sided",
                        "--camera",
                        eye.thetaRadians() + "," + eye.phiRadians() + "," + eye.rho(),
                        "--zoom",
                        Double.toString(now.zoom()),
                        "--size",
                        width + "x" + height + terms,
                        "--out",
                        now.body().stem() + "-" + shading.code() + ".png"));
    }
}
