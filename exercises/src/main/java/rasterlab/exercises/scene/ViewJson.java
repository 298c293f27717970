package rasterlab.exercises.scene;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import rasterlab.engine.naming.Named;
import rasterlab.engine.pipeline.Renderer;
import rasterlab.engine.pipeline.paint.TextureMode;
import rasterlab.engine.scene.catalogue.Scenes;
import rasterlab.engine.transform.SphericalView;

/** Views as JSON. */
final class ViewJson {
    private static final double ANY = Double.MAX_VALUE;

    private ViewJson() {}

    static SceneView read(Place file) {
        file.object("version", "scene", "detail", "camera", "projection", "look");
        file.at("version").integer(SceneFile.VERSION, SceneFile.VERSION);
        Optional<Place> look = file.optional("look");
        look.ifPresent(place -> place.object("visibility", "shading", "texture"));
        return new SceneView(
                source(file),
                file.optional("camera").map(ViewJson::camera),
                name("projection", Optional.of(file), Renderer.projections()),
                name("visibility", look, Renderer.visibilities()),
                name("shading", look, Renderer.shadings()),
                name("texture", look, TextureMode.names()));
    }

    private static SceneSource source(Place file) {
        Place scene = file.at("scene");
        Optional<Place> detail = file.optional("detail");
        if (!scene.isText()) {
            detail.ifPresent(
                    place -> {
                        throw place.wrong("is for scenes by name, not for one in the file");
                    });
            return new SceneSource.Inline(InlineScene.read(scene));
        }
        scene.made(place -> Scenes.named(place.text()));
        OptionalInt steps =
                detail.map(place -> OptionalInt.of(place.integer(1, Integer.MAX_VALUE)))
                        .orElse(OptionalInt.empty());
        return detail.orElse(scene).made(place -> new SceneSource.ByName(scene.text(), steps));
    }

    private static SphericalView camera(Place place) {
        place.object("theta", "phi", "rho");
        double theta = place.at("theta").number(-ANY, ANY);
        double phi = place.at("phi").number(-ANY, ANY);
        double rho = place.at("rho").number(SphericalView.NEAREST, SphericalView.FARTHEST);
        return new SphericalView(theta, phi, rho);
    }

    private static Optional<String> name(String field, Optional<Place> in, List<String> known) {
        return in.flatMap(place -> place.optional(field))
                .map(
                        place ->
                                place.made(
                                        given ->
                                                Named.find(
                                                        field, given.text(), known, name -> name)));
    }

    static String write(SceneView view) {
        ObjectNode file = Place.MAPPER.createObjectNode().put("version", SceneFile.VERSION);
        if (view.source() instanceof SceneSource.ByName named) {
            file.put("scene", named.name());
            named.detail().ifPresent(detail -> file.put("detail", detail));
        } else InlineScene.write(view.source().scene(), file.putObject("scene"));
        view.camera()
                .ifPresent(
                        camera ->
                                file.putObject("camera")
                                        .put("theta", camera.thetaRadians())
                                        .put("phi", camera.phiRadians())
                                        .put("rho", camera.rho()));
        view.projection().ifPresent(name -> file.put("projection", name));
        if (view.visibility().isPresent()
                || view.shading().isPresent()
                || view.texture().isPresent()) {
            ObjectNode look = file.putObject("look");
            view.visibility().ifPresent(name -> look.put("visibility", name));
            view.shading().ifPresent(name -> look.put("shading", name));
            view.texture().ifPresent(name -> look.put("texture", name));
        }
        return file.toPrettyString();
    }
}
