package rasterlab.exercises.catalogue;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.Optional;
import java.util.stream.Stream;
import rasterlab.exercises.CatalogueException;
import rasterlab.exercises.TopicGrading;
import rasterlab.exercises.document.OwnJson;
import rasterlab.exercises.json.JsonFields;
import rasterlab.exercises.scene.MethodCase;
import rasterlab.exercises.scene.SceneFile;
import rasterlab.exercises.score.Phrase;

/**
 * Scene files that cases name, such as {@code ./lab hazards --search} writes: their input stands in
 * place of their name.
 */
final class CaseScenes {
    private final ExerciseFolder folder;
    private final Optional<TopicGrading> topic;

    /**
     * @param topic whose inputs they must have; empty where it is not known
     */
    CaseScenes(ExerciseFolder folder, Optional<TopicGrading> topic) {
        this.folder = folder;
        this.topic = topic;
    }

    /** The data of a case with what its scene file has as the field {@code given}. */
    String given(JsonFields input) {
        ObjectNode all = input.tree().deepCopy();
        if (!all.has("scene")) return all.toString();
        Stream.of("given", "hazard")
                .filter(all::has)
                .findFirst()
                .ifPresent(
                        beside -> {
                            throw input.wrong("scene", Phrase.of("field.beside", beside));
                        });
        String file = input.text("scene");
        MethodCase scene = read(file);
        if (topic.isPresent() && !scene.topic().equals(topic.get().name()))
            throw input.wrong(
                    "scene", Phrase.of("field.scene", topic.get().name(), file, scene.topic()));
        all.remove("scene");
        try {
            all.set("given", OwnJson.MAPPER.readTree(scene.input()));
        } catch (JsonProcessingException e) {
            throw new AssertionError("the scene file was read as JSON before", e);
        }
        return all.toString();
    }

    private MethodCase read(String file) {
        try {
            if (SceneFile.read(folder.text(file)) instanceof MethodCase scene) return scene;
        } catch (IllegalArgumentException none) {
            throw wrong(file, Phrase.ofTheEngine(none.getMessage()));
        }
        throw wrong(file, Phrase.of("field.scene.view"));
    }

    private CatalogueException wrong(String file, Phrase why) {
        return new CatalogueException(Phrase.of("folder.at", folder.place(file), why));
    }
}
