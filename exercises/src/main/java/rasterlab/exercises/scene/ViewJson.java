package rasterlab.exercises.scene;

import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.Optional;
import java.util.OptionalInt;
import rasterlab.engine.scene.catalogue.Scenes;

/** Views as JSON. */
final class ViewJson {
    private ViewJson() {}

    static SceneView read(SceneJsonPlace file) {
        file.object(Settings.fields("version", "scene", "detail"));
        file.at("version").integer(SceneFile.VERSION, SceneFile.VERSION);
        return new SceneView(source(file), Settings.read(file));
    }

    private static SceneSource source(SceneJsonPlace file) {
        SceneJsonPlace scene = file.at("scene");
        Optional<SceneJsonPlace> detail = file.optional("detail");
        if (!scene.isText()) {
            detail.ifPresent(
                    place -> {
                        throw place.wrong("is for scenes by name, not for one in the file");
                    });
            return new SceneSource.Inline(InlineScene.read(scene.nameOrObject()));
        }
        scene.made(place -> Scenes.named(place.text()));
        OptionalInt steps =
                detail.map(place -> OptionalInt.of(place.integer(Scenes.COARSEST, Scenes.FINEST)))
                        .orElse(OptionalInt.empty());
        return detail.orElse(scene).made(place -> new SceneSource.ByName(scene.text(), steps));
    }

    static String write(SceneView view) {
        ObjectNode file = JsonNodeFactory.instance.objectNode().put("version", SceneFile.VERSION);
        if (view.source() instanceof SceneSource.ByName named) {
            file.put("scene", named.name());
            named.detail().ifPresent(detail -> file.put("detail", detail));
        } else InlineScene.write(view.source().scene(), file.putObject("scene"));
        view.settings().write(file);
        return file.toPrettyString();
    }
}
