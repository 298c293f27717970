package rasterlab.engine.scene.obj;

/** Positions, colours, texture coordinates and normals as the lines v, vt and vn give them. */
final class Vertices {
    private static final double SHORTEST = 1e-30;

    final Doubles positions = new Doubles();
    final Doubles colors = new Doubles();
    final Doubles places = new Doubles();
    final Doubles normals = new Doubles();
    private final TextLines lines;
    private final Words words;
    private final Notes notes;

    Vertices(TextLines lines, Words words, Notes notes) {
        this.lines = lines;
        this.words = words;
        this.notes = notes;
    }

    /** x y z, then a weight, a colour or both. */
    void position() throws BrokenFileException {
        words.requireArguments(3, 7);
        requireRoom(positions.size() / 3, "vertices");
        int numbers = words.count() - 1;
        if (numbers == 5) throw lines.broken("'v' needs 3 numbers, and 1, 3 or 4 more, got 5");
        for (int i = 1; i <= 3; i++) positions.add(words.number(i));
        boolean weighted = numbers == 4 || numbers == 7;
        if (weighted && words.number(4) != 1)
            notes.count(
                    "a vertex's weight, which means nothing to faces, was passed over",
                    lines.file(),
                    lines.number());
        if (numbers >= 6) {
            whiten(positions.size() - 3);
            for (int i = numbers - 2; i <= numbers; i++) colors.add(words.number(i, 1));
        }
    }

    void texture() throws BrokenFileException {
        words.requireArguments(1, 3);
        requireRoom(places.size() / 2, "texture coordinates");
        places.add(words.number(1));
        places.add(words.count() > 2 ? words.number(2) : 0);
    }

    void normal() throws BrokenFileException {
        words.requireArguments(3, 3);
        requireRoom(normals.size() / 3, "normals");
        double x = words.number(1);
        double y = words.number(2);
        double z = words.number(3);
        double length = Math.hypot(Math.hypot(x, y), z);
        if (!(length > SHORTEST))
            throw lines.broken("normal (%s, %s, %s) has no direction".formatted(x, y, z));
        normals.add(x / length);
        normals.add(y / length);
        normals.add(z / length);
    }

    private void requireRoom(int count, String what) throws BrokenFileException {
        if (count == ObjReader.MOST)
            throw lines.broken("at most " + ObjReader.MOST + " " + what + " are taken");
    }

    /** Where some vertices have colours, the others are white. */
    void finish() {
        if (colors.size() > 0) whiten(positions.size());
    }

    private void whiten(int size) {
        if (colors.size() < size)
            notes.count(
                    "vertices without a colour, beside others with one, became white",
                    lines.file(),
                    lines.number());
        while (colors.size() < size) colors.add(1);
    }
}
