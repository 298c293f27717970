package rasterlab.engine.scene.obj;

import java.io.IOException;
import java.io.Reader;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;

/** Reads the materials of one MTL file, by the rules of {@link ReadingRules#MATERIALS}. */
final class MaterialReader {
    private final TextLines lines;
    private final Words words;
    private final Notes notes;
    private final List<MaterialValues> read = new ArrayList<>();

    /** A material and the file and line that begin it. */
    record LocatedMaterial(ObjMaterial material, String place) {}

    private MaterialReader(TextLines lines, Notes notes) {
        this.lines = lines;
        this.notes = notes;
        words = new Words(lines, notes);
    }

    static List<LocatedMaterial> read(String file, Reader reader, Notes notes)
            throws IOException, BrokenFileException {
        var lines = new TextLines(file, reader);
        var materials = new MaterialReader(lines, notes);
        while (lines.advance()) {
            materials.words.divide();
            if (materials.words.count() > 0) materials.line(materials.words.get(0));
        }
        return materials.read.stream()
                .map(values -> new LocatedMaterial(values.material(), values.place))
                .toList();
    }

    private void line(String keyword) throws BrokenFileException {
        Optional<Rule> rule = ReadingRules.ofMaterials(keyword);
        if (rule.isEmpty()) notes.countKeyword(keyword, lines);
        else if (rule.get().passesOver())
            notes.count("'%s' was passed over".formatted(rule.get().keyword()), lines);
        else if (rule.get().keyword().equals("newmtl")) name();
        else if (read.isEmpty())
            notes.count(
                    "'%s' before the first 'newmtl' was passed over"
                            .formatted(rule.get().keyword()),
                    lines);
        else value(rule.get(), read.get(read.size() - 1));
    }

    private void name() {
        String name = words.name(1);
        if (name.isEmpty()) notes.count("'newmtl' has no name", lines);
        read.add(new MaterialValues(name, lines.file() + ":" + lines.number()));
    }

    private void value(Rule rule, MaterialValues material) throws BrokenFileException {
        switch (rule.keyword()) {
            case "Ka" -> material.ambient = color(rule, material.ambient);
            case "Kd" -> material.diffuse = color(rule, material.diffuse);
            case "Ks" -> material.specular = color(rule, material.specular);
            case "Ke" -> material.emitted = color(rule, material.emitted);
            case "Ns" -> material.shininess = words.number(1, rule);
            case "d" -> opacity(rule, material);
            case "Tr" -> material.transparency = OptionalDouble.of(words.number(1, rule));
            case "illum" -> material.illumination = illumination(rule);
            case "map_Kd" -> {
                Optional<ObjMaterial.Map> map = new MapOptions(lines, words, notes).read();
                if (map.isPresent()) material.diffuseMap = map;
            }
            default -> throw new AssertionError("no reader for " + rule);
        }
    }

    /** Three numbers, or one for all three; else the colour stays. */
    private List<Double> color(Rule rule, List<Double> before) throws BrokenFileException {
        int last = words.count() == 2 ? 1 : 3;
        for (int i = 1; i <= last; i++)
            if (Double.isNaN(words.value(i))) {
                words.noteUnread(i, rule);
                return before;
            }
        return List.of(
                words.number(1, rule),
                words.number(Math.min(2, last), rule),
                words.number(Math.min(3, last), rule));
    }

    private void opacity(Rule rule, MaterialValues material) throws BrokenFileException {
        boolean halo = words.count() > 1 && words.get(1).equals("-halo");
        if (halo) notes.count("option '-halo' was passed over", lines);
        material.opacity = OptionalDouble.of(words.number(halo ? 2 : 1, rule));
    }

    private int illumination(Rule rule) throws BrokenFileException {
        double number = words.number(1, rule);
        if (number == Math.rint(number)) return (int) number;
        words.noteUnread(1, rule);
        return (int) rule.numberInstead();
    }
}
