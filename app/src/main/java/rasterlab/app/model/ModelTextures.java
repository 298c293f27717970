package rasterlab.app.model;

import java.io.IOException;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import rasterlab.app.outcome.Complaint;
import rasterlab.app.outcome.PictureFile;
import rasterlab.app.outcome.WholeFile;
import rasterlab.engine.scene.obj.ObjMaterial;
import rasterlab.engine.scene.obj.TextureFiles;
import rasterlab.engine.texture.Texture;

/** The pictures of a model, each read once; what cannot be read is told and left out. */
final class ModelTextures implements TextureFiles {
    private static final String INSTEAD = "; the colour Kd stands for it";

    private final ModelFolder folder;
    private final Consumer<String> notes;
    private final Map<Path, Optional<Texture>> read = new HashMap<>();

    ModelTextures(ModelFolder folder, Consumer<String> notes) {
        this.folder = folder;
        this.notes = notes;
    }

    @Override
    public Optional<Texture> open(ObjMaterial.Map map) {
        String name = map.names().get(map.names().size() - 1);
        try {
            Optional<ModelFolder.FoundFile> found = folder.find(map.names());
            if (found.isPresent()) {
                String taken = found.get().name();
                if (!taken.equals(map.names().get(0))) noteOther(map, taken);
                return read.computeIfAbsent(found.get().file(), file -> picture(file, map.place()));
            }
            notes.accept(
                    "%s: there is no texture '%s' in the model's folder%s"
                            .formatted(map.place(), name, INSTEAD));
        } catch (IOException e) {
            notes.accept(
                    "%s: texture '%s' cannot be read: %s%s"
                            .formatted(map.place(), name, WholeFile.reason(e), INSTEAD));
        }
        return Optional.empty();
    }

    /** The name as it stands may have a comment or an option's word in it. */
    private void noteOther(ObjMaterial.Map map, String taken) {
        notes.accept(
                "%s: there is no texture '%s'; '%s' was taken"
                        .formatted(map.place(), map.names().get(0), taken));
    }

    private Optional<Texture> picture(Path file, String place) {
        try {
            return Optional.of(PictureFile.texture(file));
        } catch (Complaint e) {
            notes.accept("%s: %s%s".formatted(place, e.getMessage(), INSTEAD));
            return Optional.empty();
        }
    }
}
