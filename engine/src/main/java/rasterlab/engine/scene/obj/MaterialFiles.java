package rasterlab.engine.scene.obj;

import java.io.IOException;
import java.io.Reader;
import java.util.Optional;

/** Opens the material files that a model names. */
@FunctionalInterface
public interface MaterialFiles {
    /**
     * @param name as the model's file has it; it may be any text, so take it for no path unchecked
     * @return its text, closed by whoever reads it; empty where there is no such file
     * @throws IOException if it is there but cannot be read
     */
    Optional<Reader> open(String name) throws IOException;
}
