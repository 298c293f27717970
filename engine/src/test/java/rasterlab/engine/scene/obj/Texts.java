package rasterlab.engine.scene.obj;

import java.io.IOException;
import java.io.StringReader;
import java.util.Map;
import java.util.Optional;

/** Reads models from strings. */
final class Texts {
    static final String SQUARE = "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\n";

    private Texts() {}

    static ObjModel read(String obj) throws IOException, BrokenFileException {
        return read(obj, "newmtl red\nKd 1 0 0\nnewmtl blue sky\nKd 0 0 1\n");
    }

    /** A model read with a material file {@code m.mtl}. */
    static ObjModel read(String obj, String mtl) throws IOException, BrokenFileException {
        var files = Map.of("m.mtl", mtl, "my m.mtl", "newmtl wood\n");
        return ObjReader.read(
                "a.obj",
                new StringReader(obj),
                name -> Optional.ofNullable(files.get(name)).map(StringReader::new));
    }
}
