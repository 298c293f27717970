package rasterlab.engine.scene.obj;

import java.io.IOException;
import java.io.Reader;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** Reads the materials of one MTL file. */
final class MaterialReader {
    private static final double BRIGHTEST = 1e6;
    private static final double SHARPEST = 1000;
    private static final int LAST_ILLUMINATION = 10;

    private final TextLines lines;
    private final Words words;
    private final Notes notes;
    private final List<MaterialValues> read = new ArrayList<>();

    private MaterialReader(TextLines lines, Notes notes) {
        this.lines = lines;
        this.notes = notes;
        words = new Words(lines);
    }

    static List<ObjMaterial> read(String file, Reader reader, Notes notes)
            throws IOException, BrokenFileException {
        var lines = new TextLines(file, reader);
        var materials = new MaterialReader(lines, notes);
        while (lines.advance()) {
            materials.words.divide();
            if (materials.words.count() > 0) materials.line();
        }
        return materials.read.stream().map(MaterialValues::material).toList();
    }

    private void line() throws BrokenFileException {
        String keyword = words.get(0);
        if (keyword.equals("newmtl")) read.add(new MaterialValues(words.name()));
        else if (read.isEmpty())
            throw lines.broken(
                    "'%s' comes before the first 'newmtl'".formatted(Words.shown(keyword)));
        else value(keyword, read.get(read.size() - 1));
    }

    private void value(String keyword, MaterialValues material) throws BrokenFileException {
        switch (keyword) {
            case "Ka" -> material.ambient = color(1);
            case "Kd" -> material.diffuse = color(1);
            case "Ks" -> material.specular = color(1);
            case "Ke" -> material.emitted = color(BRIGHTEST);
            case "Ns" -> material.shininess = one(SHARPEST);
            case "d" -> material.opacity = one(1);
            case "Tr" -> material.opacity = 1 - one(1);
            case "illum" -> material.illumination = illumination();
            case "map_Kd" -> material.diffuseMap = Optional.of(map());
            default -> notes.countKeyword(keyword, lines);
        }
    }

    /** Three numbers, or one for all three. */
    private List<Double> color(double most) throws BrokenFileException {
        if (words.count() != 2) words.requireArguments(3, 3);
        int last = words.count() - 1;
        return List.of(
                words.number(1, most),
                words.number(Math.min(2, last), most),
                words.number(Math.min(3, last), most));
    }

    private double one(double most) throws BrokenFileException {
        words.requireArguments(1, 1);
        return words.number(1, most);
    }

    private int illumination() throws BrokenFileException {
        double number = one(LAST_ILLUMINATION);
        if (number != Math.rint(number))
            throw lines.broken("'illum' needs a whole number, got '" + words.get(1) + "'");
        return (int) number;
    }

    /** Options would change how the texture lies, so they are refused, not passed over. */
    private ObjMaterial.Map map() throws BrokenFileException {
        String name = words.name();
        if (name.startsWith("-"))
            throw lines.broken("'map_Kd' is read without options, got '" + Words.shown(name) + "'");
        return new ObjMaterial.Map(name, lines.file() + ":" + lines.number());
    }
}
