package rasterlab.engine.scene.obj;

import java.io.IOException;
import java.io.Reader;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** The materials of a model, numbered in the order they are read. */
final class Materials {
    private static final int MOST_NAMED = 20;

    private final TextLines lines;
    private final MaterialFiles files;
    private final Notes notes;
    private final List<ObjMaterial> all = new ArrayList<>();
    private final Map<String, Integer> numbers = new HashMap<>();
    private int unnamed = Faces.NONE;

    Materials(TextLines lines, MaterialFiles files, Notes notes) {
        this.lines = lines;
        this.files = files;
        this.notes = notes;
    }

    /** Reads the files of a line mtllib: one whose name has blanks, or several. */
    void read(Words words) throws IOException, BrokenFileException {
        if (words.count() == 2 || !readIfThere(words.name()))
            for (int i = 1; i < Math.max(2, words.count()); i++) {
                String name = i < words.count() ? words.get(i) : words.name();
                if (!readIfThere(name))
                    throw lines.broken("there is no material file '" + Words.shown(name) + "'");
            }
    }

    private boolean readIfThere(String name) throws IOException, BrokenFileException {
        Optional<Reader> found = opened(name);
        if (found.isEmpty()) return false;
        try (Reader reader = found.get()) {
            for (ObjMaterial material : MaterialReader.read(name, reader, notes)) add(material);
        }
        return true;
    }

    private Optional<Reader> opened(String name) throws BrokenFileException {
        try {
            return files.open(name);
        } catch (IOException e) {
            throw lines.broken(
                    "material file '%s' cannot be read: %s"
                            .formatted(Words.shown(name), e.getMessage()));
        }
    }

    private void add(ObjMaterial material) {
        if (numbers.putIfAbsent(material.name(), all.size()) == null) all.add(material);
        else
            notes.count(
                    "a material of a name that was there before was passed over",
                    lines.file(),
                    lines.number());
    }

    int numberOf(String name) throws BrokenFileException {
        Integer number = numbers.get(name);
        if (number == null) throw lines.broken(unknown(name));
        return number;
    }

    private String unknown(String name) {
        String start = "there is no material '" + Words.shown(name) + "'";
        List<String> known = new ArrayList<>();
        for (ObjMaterial material : all)
            if (known.size() < MOST_NAMED && !material.name().isEmpty())
                known.add(Words.shown(material.name()));
        if (known.isEmpty()) return start + ", and no 'mtllib' above names a file that has any";
        return start + "; the files above have " + String.join(", ", known);
    }

    /** The number of the material for faces above the first usemtl. */
    int unnamed() {
        if (unnamed == Faces.NONE) {
            unnamed = all.size();
            all.add(ObjMaterial.unnamed());
        }
        return unnamed;
    }

    /** A face without texture coordinates cannot show its material's texture. */
    void noteMissingTexture(Faces faces) {
        for (int f = 0; f < faces.count(); f++)
            if (faces.texture(f, 0) == Faces.NONE
                    && all.get(faces.material(f)).diffuseMap().isPresent())
                notes.count(
                        "a face without texture coordinates, whose material has a texture, took 0, 0",
                        lines.file(),
                        0);
    }

    List<ObjMaterial> all() {
        return List.copyOf(all);
    }
}
