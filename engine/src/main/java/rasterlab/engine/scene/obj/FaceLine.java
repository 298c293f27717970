package rasterlab.engine.scene.obj;

/** The corners on one line {@code f}: v, v/vt, v//vn or v/vt/vn, all of the same form. */
final class FaceLine {
    private static final String FORMS = "allowed are v, v/vt, v//vn and v/vt/vn";
    private static final int MOST_DIGITS = 9;

    private final TextLines lines;
    private final Words words;
    private final int[] parts = new int[3];

    final Ints vertex = new Ints();
    final Ints texture = new Ints();
    final Ints normal = new Ints();

    FaceLine(TextLines lines, Words words) {
        this.lines = lines;
        this.words = words;
    }

    /**
     * @param counts how many vertices, texture coordinates and normals there are so far
     */
    void read(int... counts) throws BrokenFileException {
        vertex.clear();
        texture.clear();
        normal.clear();
        if (words.count() < 4)
            throw lines.broken("a face needs at least 3 corners, got " + (words.count() - 1));
        for (int corner = 1; corner < words.count(); corner++) {
            corner(corner, counts);
            vertex.add(parts[0]);
            texture.add(parts[1]);
            normal.add(parts[2]);
            boolean alike = texture.get(0) < 0 == parts[1] < 0 && normal.get(0) < 0 == parts[2] < 0;
            if (!alike)
                throw lines.broken(
                        "face corner %d is '%s' but corner 1 is '%s'; give all corners one form"
                                .formatted(corner, shown(corner), shown(1)));
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
            if (part > 2 || empty && (part != 1 || at == end)) throw form(corner);
            if (!empty) parts[part] = number(corner, part, from, at, counts[part]);
            part++;
            from = at + 1;
        }
    }

    private BrokenFileException form(int corner) {
        return lines.broken("face corner %d is '%s'; %s".formatted(corner, shown(corner), FORMS));
    }

    /** From 1, or backwards from −1, to the number from 0. */
    private int number(int corner, int part, int from, int to, int count)
            throws BrokenFileException {
        CharSequence text = lines.text();
        boolean negative = text.charAt(from) == '-';
        int digits = negative ? from + 1 : from;
        if (digits == to) throw form(corner);
        for (int at = digits; at < to; at++)
            if (text.charAt(at) < '0' || text.charAt(at) > '9') throw form(corner);
        boolean fits = to - digits <= MOST_DIGITS;
        int size = fits ? Integer.parseInt(text, digits, to, 10) : Integer.MAX_VALUE;
        if (size == 0 || size > count)
            throw lines.broken(
                    "face corner %d names %s %s; there are %d%s"
                            .formatted(
                                    corner,
                                    new String[] {"vertex", "texture place", "normal"}[part],
                                    Words.shown(text.subSequence(from, to).toString()),
                                    count,
                                    size == 0 ? ", counted from 1 or back from -1" : ""));
        return negative ? count - size : size - 1;
    }
}
