package rasterlab.engine.scene.obj;

/**
 * The corners on one line {@code f}, {@code l} or {@code p}: v, v/vt, v//vn or v/vt/vn.
 *
 * <p>A vertex must be there. A place of a texture or a normal that is not there counts as not
 * named, and so do places of textures that some corners name and others do not.
 */
final class FaceLine {
    private static final String FORMS = "allowed are v, v/vt, v//vn and v/vt/vn";
    private static final int MOST_DIGITS = 9;

    /** Stands for a number that is not there, 0 or no number. */
    private static final int MISSING = -2;

    private final TextLines lines;
    private final Words words;
    private final Notes notes;
    private final int[] parts = new int[3];

    final Ints vertex = new Ints();
    final Ints texture = new Ints();
    final Ints normal = new Ints();

    FaceLine(TextLines lines, Words words, Notes notes) {
        this.lines = lines;
        this.words = words;
        this.notes = notes;
    }

    /**
     * @param counts how many vertices, texture coordinates and normals there are so far
     */
    void read(int... counts) throws BrokenFileException {
        vertex.clear();
        texture.clear();
        normal.clear();
        int places = 0;
        for (int corner = 1; corner < words.count(); corner++) {
            corner(corner, counts);
            vertex.add(parts[0]);
            texture.add(parts[1]);
            normal.add(parts[2]);
            if (parts[1] != Faces.NONE) places++;
        }
        if (places > 0 && places < vertex.size()) {
            notes.count(
                    "places of a texture that some corners of a face lack were passed over", lines);
            for (int k = 0; k < texture.size(); k++) texture.set(k, Faces.NONE);
        }
    }

    private String shown(int corner) {
        return Words.shown(words.get(corner));
    }

    private void corner(int corner, int[] counts) throws BrokenFileException {
        parts[1] = Faces.NONE;
        parts[2] = Faces.NONE;
        int part = 0;
        int from = words.begin(corner);
        int end = words.end(corner);
        for (int at = from; at <= end; at++) {
            if (at < end && lines.text().charAt(at) != '/') continue;
            boolean empty = at == from;
            if (part == 0) parts[0] = vertex(corner, from, at, counts[0]);
            else if (!empty && part <= 2) parts[part] = other(corner, part, from, at, counts[part]);
            else if (!empty)
                notes.count("a face corner's numbers after v/vt/vn were passed over", lines);
            part++;
            from = at + 1;
        }
    }

    private int vertex(int corner, int from, int to, int count) throws BrokenFileException {
        int number = number(from, to, count);
        if (number >= 0) return number;
        if (!isWhole(from, to))
            throw lines.broken(
                    "face corner %d is '%s'; %s".formatted(corner, shown(corner), FORMS));
        String name = lines.text().subSequence(from, to).toString();
        boolean zero = name.matches("-?0+");
        throw lines.broken(
                "face corner %d names vertex %s; there are %d%s"
                        .formatted(
                                corner,
                                Words.shown(name),
                                count,
                                zero ? ", counted from 1 or back from -1" : ""));
    }

    /** A place of a texture or a normal. */
    private int other(int corner, int part, int from, int to, int count) {
        int number = number(from, to, count);
        if (number >= 0) return number;
        String what = part == 1 ? "texture place" : "normal";
        notes.count(
                what,
                () ->
                        "face corner %d names %s %s, which is not there; it was passed over"
                                .formatted(
                                        corner,
                                        what,
                                        Words.shown(lines.text().subSequence(from, to).toString())),
                lines);
        return Faces.NONE;
    }

    private boolean isWhole(int from, int to) {
        int digits = from < to && lines.text().charAt(from) == '-' ? from + 1 : from;
        if (digits == to) return false;
        for (int at = digits; at < to; at++)
            if (lines.text().charAt(at) < '0' || lines.text().charAt(at) > '9') return false;
        return true;
    }

    /** The index from 0 for a written number, which counts from 1, or backwards from −1. */
    private int number(int from, int to, int count) {
        if (!isWhole(from, to)) return MISSING;
        CharSequence text = lines.text();
        boolean negative = text.charAt(from) == '-';
        int digits = negative ? from + 1 : from;
        if (to - digits > MOST_DIGITS) return MISSING;
        int size = 0;
        for (int at = digits; at < to; at++) size = 10 * size + text.charAt(at) - '0';
        if (size == 0 || size > count) return MISSING;
        return negative ? count - size : size - 1;
    }
}
