package rasterlab.engine.scene.obj;

import java.io.IOException;
import java.io.Reader;
import java.util.Optional;

/**
 * Reads a model line by line, by {@link ReadingRules}, which say what is read and what becomes of
 * the rest.
 *
 * <p>A face may name only what stands above it. At most {@value #MOST} vertices, texture
 * coordinates, normals and triangles are taken, and lines of 2²⁰ characters. Time is proportional
 * to the text's length, except for faces to be cut, see {@link FaceCutter#MOST_CORNERS}.
 *
 * <p>Source: Wavefront Technologies, Advanced Visualizer manual, appendix B1, object files (.obj),
 * and its material library format.
 */
public final class ObjReader {
    static final int MOST = 10_000_000;

    private final TextLines lines;
    private final Words words;
    private final FaceLine face;
    private final FaceCutter cutter;
    private final Vertices vertices;
    private final Materials materials;
    private final Notes notes = new Notes();
    private final Faces faces = new Faces();
    private final LinesAndPoints strokes = new LinesAndPoints();
    private int material = Faces.NONE;
    private int smoothing;
    private long triangles;
    private String firstUnknown = "";
    private int unknownLine;
    private String firstPassedOver = "";
    private int passedOverLine;

    private ObjReader(TextLines lines, MaterialFiles files) {
        this.lines = lines;
        words = new Words(lines, notes);
        face = new FaceLine(lines, words, notes);
        vertices = new Vertices(lines, words, notes);
        materials = new Materials(lines, files, notes);
        cutter = new FaceCutter(lines, notes, vertices.positions, faces);
    }

    /**
     * @param name of the file, for messages
     * @param reader its text, which stays open
     * @param files opens the material files that it names
     * @throws IOException if the text cannot be read
     * @throws BrokenFileException naming file, line, what is there and what is allowed
     */
    public static ObjModel read(String name, Reader reader, MaterialFiles files)
            throws IOException, BrokenFileException {
        var lines = new TextLines(name, reader);
        return new ObjReader(lines, files).read();
    }

    private ObjModel read() throws IOException, BrokenFileException {
        while (lines.advance()) {
            words.divide();
            if (words.count() > 0) line(words.get(0));
        }
        if (faces.count() == 0 && strokes.count() == 0) throw nothing();
        vertices.finish();
        double[] normals =
                new MissingNormals(vertices.positions, vertices.normals, faces).complete();
        materials.settleMissing();
        materials.noteMissingTexture(faces);
        materials.showWhatVanishes(faces);
        return new ObjModel(vertices, normals, faces, strokes, materials.all(), notes.all());
    }

    /** Names the first line that was left out, or that shows that the text is no model at all. */
    private BrokenFileException nothing() {
        String missing = "no face with an area, no line and no point";
        if (notes.firstLeftOut().isPresent())
            return new BrokenFileException(
                    lines.file(),
                    notes.firstLeftOut().get().line(),
                    notes.firstLeftOut().get().why() + "; " + missing + " is in the file");
        if (passedOverLine > 0)
            return new BrokenFileException(
                    lines.file(),
                    passedOverLine,
                    "'%s' cannot be read; faces, lines and points are, curves and surfaces are not; "
                                    .formatted(firstPassedOver)
                            + missing
                            + " is in the file");
        if (unknownLine == 0)
            return new BrokenFileException(lines.file(), 0, missing + " is in it");
        return new BrokenFileException(
                lines.file(),
                unknownLine,
                "'%s' begins no line of a Wavefront model, which has v, vt, vn, f, s, usemtl,"
                                .formatted(firstUnknown)
                        + " mtllib, o, g, l and p; "
                        + missing
                        + " is in the file");
    }

    private void line(String keyword) throws IOException, BrokenFileException {
        switch (keyword) {
            case "v" -> vertices.position();
            case "vt" -> vertices.texture();
            case "vn" -> vertices.normal();
            case "f" -> face();
            case "l", "p" -> stroke(keyword);
            case "s" -> smoothing = smoothing();
            case "usemtl" -> material = materials.numberOf(words);
            case "mtllib" -> materials.read(words);
            default -> passOver(keyword);
        }
    }

    private void passOver(String keyword) {
        Optional<Rule> rule = ReadingRules.ofModel(keyword);
        if (rule.isEmpty()) {
            if (unknownLine == 0) {
                unknownLine = lines.number();
                firstUnknown = Words.shown(keyword);
            }
            notes.countKeyword(keyword, lines);
        } else if (rule.get().treatment() == Rule.Treatment.PASSED_OVER) {
            if (passedOverLine == 0) {
                passedOverLine = lines.number();
                firstPassedOver = keyword;
            }
            notes.count(
                    "'" + keyword + "' was passed over; faces, lines and points are read", lines);
        }
    }

    private void corners() throws BrokenFileException {
        face.read(
                vertices.positions.size() / 3,
                vertices.places.size() / 2,
                vertices.normals.size() / 3);
    }

    private void face() throws BrokenFileException {
        corners();
        if (face.vertex.size() < 3) {
            String few = "a face of fewer than 3 corners was left out";
            notes.leaveOut(few, few, lines);
            return;
        }
        for (int k = 0; k < face.normal.size(); k++) {
            int normal = face.normal.get(k);
            if (normal != Faces.NONE && !vertices.hasDirection(normal))
                face.normal.set(k, Faces.NONE);
        }
        count(face.vertex.size() - 2);
        cutter.add(face, material(), smoothing);
    }

    private void stroke(String keyword) {
        boolean line = keyword.equals("l");
        try {
            corners();
            count(StrokeFaces.MOST_TRIANGLES * (long) face.vertex.size());
        } catch (BrokenFileException e) {
            notes.leaveOut(
                    "'" + keyword + "' that cannot be read was left out",
                    "'%s' was left out: %s".formatted(keyword, e.problem()),
                    lines);
            return;
        }
        String few = "'" + keyword + "' of too few vertices was left out";
        if (face.vertex.size() < (line ? 2 : 1)) notes.leaveOut(few, few, lines);
        else if (line) strokes.line(face, material());
        else strokes.points(face, material());
    }

    private int material() {
        if (material == Faces.NONE) material = materials.unnamed();
        return material;
    }

    private void count(long more) throws BrokenFileException {
        triangles += more;
        if (triangles > MOST)
            throw lines.broken("at most " + MOST + " triangles are taken, and here are more");
    }

    private int smoothing() throws BrokenFileException {
        String group = words.count() > 1 ? words.get(1) : "";
        if (group.equals("off")) return 0;
        if (group.equals("on")) return 1;
        double number = words.number(1, ReadingRules.SMOOTHING);
        if (number == Math.rint(number)) return (int) number;
        words.noteUnread(1, ReadingRules.SMOOTHING);
        return 0;
    }
}
