package rasterlab.engine.scene.obj;

import java.io.IOException;
import java.io.Reader;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;

/**
 * The materials of a model, numbered in the order they are read.
 *
 * <p>Names that differ are different materials, those that no file has too. Only where no material
 * has a name, and no other name of the model is the same but for what may be a comment, it is
 * looked for without that.
 */
final class Materials {
    /** An opacity below this changes no level of a picture. */
    private static final double LEAST_SEEN = 0.5 / 255;

    private final TextLines lines;
    private final MaterialFiles files;
    private final Notes notes;
    private final List<ObjMaterial> all = new ArrayList<>();
    private final Map<String, Integer> numbers = new HashMap<>();

    /** Materials by their names without what may be a comment; none where two have the same. */
    private final Map<String, Integer> bare = new HashMap<>();

    /** The first line that names each missing material, and how many lines do. */
    private final Map<Integer, StandIn> standIns = new TreeMap<>();

    private int unnamed = Faces.NONE;

    /** The names that the model's lines usemtl have. */
    private final Set<String> used = new HashSet<>();

    /** How many of them are the same without what may be a comment. */
    private final Map<String, Integer> usedBare = new HashMap<>();

    private record StandIn(String name, int line, int uses) {
        StandIn usedAgain() {
            return new StandIn(name, line, uses + 1);
        }
    }

    Materials(TextLines lines, MaterialFiles files, Notes notes) {
        this.lines = lines;
        this.files = files;
        this.notes = notes;
    }

    /** Reads the files of a line mtllib: one whose name has blanks, or several. */
    void read(Words words) throws IOException {
        for (String name : words.names(1))
            if (readIfThere(name)) {
                if (!name.equals(words.name(1)))
                    notes.count(
                            "material file without its comment",
                            without("material file", words.name(1), name),
                            lines);
                return;
            }
        boolean several = words.count() > 2;
        for (int i = 1; several && i < words.count(); i++)
            if (!readIfThere(words.get(i))) noteMissingFile(words.get(i));
        if (!several) noteMissingFile(words.name(1));
    }

    private static String without(String what, String name, String taken) {
        return "there is no %s '%s'; '%s' was taken, since a # behind a blank may begin a comment"
                .formatted(what, Words.shown(name), Words.shown(taken));
    }

    private void noteMissingFile(String name) {
        notes.count(
                "missing material file",
                name.isEmpty()
                        ? "'mtllib' has no name"
                        : "there is no material file '%s'; it was passed over"
                                .formatted(Words.shown(name)),
                lines);
    }

    private boolean readIfThere(String name) throws IOException {
        if (name.isEmpty()) return false;
        Optional<Reader> found;
        try {
            found = files.open(name);
        } catch (IOException e) {
            noteUnread(name, e.getMessage());
            return true;
        }
        if (found.isEmpty()) return false;
        try (Reader reader = found.get()) {
            for (MaterialReader.LocatedMaterial read : MaterialReader.read(name, reader, notes))
                add(read);
        } catch (BrokenFileException e) {
            noteUnread(name, e.getMessage());
        }
        return true;
    }

    private void noteUnread(String name, String reason) {
        notes.count(
                "unread material file",
                "material file '%s' was passed over: %s".formatted(Words.shown(name), reason),
                lines);
    }

    private void add(MaterialReader.LocatedMaterial read) {
        ObjMaterial material = read.material();
        int number = numbers.computeIfAbsent(material.name(), name -> all.size());
        if (number == all.size()) all.add(material);
        else if (standIns.remove(number) != null) all.set(number, material);
        else {
            notes.countAt(read.place(), "material given twice", givenTwice(material.name()), 1);
            return;
        }
        bare.merge(bare(material.name()), number, (one, other) -> Faces.NONE);
    }

    private static String givenTwice(String name) {
        return name.isEmpty()
                ? "a material without a name is given twice; the first counts"
                : "material '%s' is given twice; the first counts".formatted(Words.shown(name));
    }

    private static String bare(String name) {
        return name.replaceFirst("[ \\t]+#.*", "");
    }

    /** The number of the material that a line usemtl names. */
    int numberOf(Words words) {
        String name = words.name(1);
        Integer known = numbers.get(name);
        if (used.add(name)) usedBare.merge(bare(name), 1, Integer::sum);
        if (known == null) {
            known = all.size();
            numbers.put(name, known);
            all.add(ObjMaterial.standard(name));
            standIns.put(known, new StandIn(name, lines.number(), 0));
        }
        standIns.computeIfPresent(known, (n, was) -> was.usedAgain());
        return known;
    }

    /**
     * Looks for what no file has, without what may be a comment; what is not found so either stays
     * the default material. A material may stand in a file that is named below its use, so all this
     * is done at the end.
     */
    void settleMissing() {
        standIns.entrySet().stream()
                .sorted(Comparator.comparing(entry -> entry.getValue().line()))
                .forEach(entry -> settle(entry.getKey(), entry.getValue()));
    }

    private void settle(int number, StandIn missing) {
        String place = lines.file() + ":" + missing.line();
        int meant = bare.getOrDefault(bare(missing.name()), Faces.NONE);
        if (meant == Faces.NONE || usedBare.get(bare(missing.name())) > 1) {
            notes.countAt(place, "missing material", unknown(missing.name()), missing.uses());
            return;
        }
        String name = all.get(meant).name();
        notes.countAt(
                place,
                "material without its comment",
                without("material", missing.name(), name),
                missing.uses());
        all.set(number, all.get(meant));
    }

    private static String unknown(String name) {
        return name.isEmpty()
                ? "'usemtl' has no name; the default material stands for it"
                : "there is no material '%s'; the default one stands for it"
                        .formatted(Words.shown(name));
    }

    /** The number of the material for faces above the first usemtl. */
    int unnamed() {
        if (unnamed == Faces.NONE) {
            unnamed = all.size();
            all.add(ObjMaterial.standard(""));
        }
        return unnamed;
    }

    /** A face without texture coordinates cannot show its material's texture. */
    void noteMissingTexture(Faces faces) {
        for (int f = 0; f < faces.count(); f++)
            if (faces.texture(f, 0) == Faces.NONE
                    && all.get(faces.material(f)).diffuseMap().isPresent())
                notes.countIn(
                        lines.file(),
                        "a face without texture coordinates, whose material has a texture, took 0, 0");
    }

    /** Where nothing would be seen, everything becomes opaque; where some would not, it is told. */
    void showWhatVanishes(Faces faces) {
        int vanishing = 0;
        for (int f = 0; f < faces.count(); f++)
            if (all.get(faces.material(f)).opacity() < LEAST_SEEN) vanishing++;
        if (vanishing == 0) return;
        if (vanishing < faces.count()) {
            for (int f = 0; f < faces.count(); f++)
                if (all.get(faces.material(f)).opacity() < LEAST_SEEN)
                    notes.countIn(
                            lines.file(),
                            "a face that 'd' or 'Tr' makes transparent altogether is not seen");
            return;
        }
        notes.countIn(
                lines.file(),
                "'d' or 'Tr' makes all faces transparent altogether; they are drawn opaque");
        all.replaceAll(ObjMaterial::opaque);
    }

    List<ObjMaterial> all() {
        return List.copyOf(all);
    }
}
