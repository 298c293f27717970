package rasterlab.engine.scene.obj;

import java.io.IOException;
import java.io.Reader;
import java.util.Set;

/**
 * Reads a model line by line.
 *
 * <p>Read are v (with a weight or a colour), vt, vn, f, s, usemtl and mtllib; o and g change
 * nothing and are passed over; l and p draw no faces and are counted in the notes, as unknown
 * keywords are. Curves, surfaces and what would run or read something else are refused. A face may
 * name only what stands above it. At most {@value #MOST} vertices, texture coordinates, normals and
 * triangles are taken, and lines of 2²⁰ characters. Time is proportional to the text's length,
 * except for faces to be cut, see {@link FaceCutter#MOST_CORNERS}.
 *
 * <p>Source: Wavefront Technologies, Advanced Visualizer manual, appendix B1, object files (.obj),
 * and its material library format.
 */
public final class ObjReader {
    static final int MOST = 10_000_000;

    private static final Set<String> REFUSED =
            Set.of(
                    "vp", "cstype", "deg", "bmat", "step", "curv", "curv2", "surf", "parm", "trim",
                    "hole", "scrv", "sp", "end", "con", "call", "csh", "bzp", "bsp", "cdc", "cdp",
                    "res");

    private final TextLines lines;
    private final Words words;
    private final FaceLine face;
    private final FaceCutter cutter;
    private final Vertices vertices;
    private final Materials materials;
    private final Notes notes = new Notes();
    private final Faces faces = new Faces();
    private int material = Faces.NONE;
    private int smoothing;
    private long triangles;
    private String firstUnknown = "";
    private int unknownLine;

    private ObjReader(TextLines lines, MaterialFiles files) {
        this.lines = lines;
        words = new Words(lines);
        face = new FaceLine(lines, words);
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
        if (faces.count() == 0) throw noFace();
        vertices.finish();
        double[] normals =
                new MissingNormals(vertices.positions, vertices.normals, faces).complete();
        materials.noteMissingTexture(faces);
        return new ObjModel(vertices, normals, faces, materials.all(), notes.all());
    }

    /** Of a text that is no model at all the first line that shows it is named. */
    private BrokenFileException noFace() {
        if (unknownLine == 0)
            return new BrokenFileException(lines.file(), 0, "no face with an area is in it");
        return new BrokenFileException(
                lines.file(),
                unknownLine,
                "'%s' begins no line of a Wavefront model, which has v, vt, vn, f, s, usemtl,"
                                .formatted(firstUnknown)
                        + " mtllib, o, g, l and p; no face with an area is in the file");
    }

    private void line(String keyword) throws IOException, BrokenFileException {
        switch (keyword) {
            case "v" -> vertices.position();
            case "vt" -> vertices.texture();
            case "vn" -> vertices.normal();
            case "f" -> face();
            case "s" -> smoothing = smoothing();
            case "usemtl" -> material = materials.numberOf(words.name());
            case "mtllib" -> materials.read(words);
            case "o", "g" -> {}
            case "l", "p" ->
                    notes.count(
                            "'" + keyword + "' was passed over, only faces are read",
                            lines.file(),
                            lines.number());
            default -> other(keyword);
        }
    }

    private void other(String keyword) throws BrokenFileException {
        if (REFUSED.contains(keyword))
            throw lines.broken(
                    "'"
                            + keyword
                            + "' cannot be read; faces ('f') are, curves and surfaces are not");
        if (unknownLine == 0) {
            unknownLine = lines.number();
            firstUnknown = Words.shown(keyword);
        }
        notes.countKeyword(keyword, lines);
    }

    private void face() throws BrokenFileException {
        face.read(
                vertices.positions.size() / 3,
                vertices.places.size() / 2,
                vertices.normals.size() / 3);
        triangles += face.vertex.size() - 2;
        if (triangles > MOST)
            throw lines.broken("at most " + MOST + " triangles are taken, and here are more");
        if (material == Faces.NONE) material = materials.unnamed();
        cutter.add(face, material, smoothing);
    }

    private int smoothing() throws BrokenFileException {
        words.requireArguments(1, 1);
        if (words.get(1).equals("off")) return 0;
        double group = words.number(1, Integer.MAX_VALUE);
        if (group != Math.rint(group))
            throw lines.broken("'s' needs 'off' or a whole number, got '" + words.get(1) + "'");
        return (int) group;
    }
}
