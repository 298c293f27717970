package rasterlab.app.light;

import java.nio.file.Path;
import java.util.Optional;
import rasterlab.engine.scene.obj.UpAxis;

/**
 * The file of the body that is lit, as it is kept between runs: by its place, for it may be another
 * one by then.
 *
 * @param file empty where the body is the lab's
 * @param normals of the body, as in {@link LitBody}
 * @param up the axis of a model that points up
 */
record LitFile(Optional<Path> file, String normals, UpAxis up) {
    static final LitFile NONE = new LitFile(Optional.empty(), LitBody.OWN, UpAxis.Y);

    LitFile {
        if (!LitBody.NORMALS.contains(normals))
            throw new IllegalArgumentException(
                    "normals must be one of %s, got '%s'".formatted(LitBody.NORMALS, normals));
    }

    static LitFile of(LitBody body) {
        return body.opened()
                .map(
                        scene ->
                                new LitFile(
                                        Optional.of(scene.file()),
                                        body.normals(),
                                        scene.up().orElse(UpAxis.Y)))
                .orElse(NONE);
    }
}
