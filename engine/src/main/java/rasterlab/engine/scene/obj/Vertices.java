package rasterlab.engine.scene.obj;

import java.util.BitSet;

/** Positions, colours, texture coordinates and normals as the lines v, vt and vn give them. */
final class Vertices {
    private static final double SHORTEST = 1e-30;

    final Doubles positions = new Doubles();
    final Doubles colors = new Doubles();
    final Doubles places = new Doubles();
    final Doubles normals = new Doubles();
    private final BitSet withoutDirection = new BitSet();
    private final TextLines lines;
    private final Words words;
    private final Notes notes;

    Vertices(TextLines lines, Words words, Notes notes) {
        this.lines = lines;
        this.words = words;
        this.notes = notes;
    }

    /** Reads x y z, then a weight, a colour or both. */
    void position() throws BrokenFileException {
        words.requireNumbers(3);
        requireRoom(positions.size() / 3, "vertices");
        for (int i = 1; i <= 3; i++) positions.add(words.number(i, ReadingRules.POSITION));
        int more = words.count() - 4;
        if (more == 0) return;
        boolean weighted = more == 1 || more == 4;
        if (weighted && words.value(4) != 1)
            notes.count("a vertex's weight, which means nothing to faces, was passed over", lines);
        if (more == 2 || more > 4)
            notes.count("a vertex's numbers without a meaning were passed over", lines);
        if (more >= 3) color(more == 4 ? 5 : 4);
    }

    private void color(int first) throws BrokenFileException {
        whiten(positions.size() - 3);
        for (int i = first; i < first + 3; i++) colors.add(words.number(i, ReadingRules.COLOR));
    }

    void texture() throws BrokenFileException {
        requireRoom(places.size() / 2, "texture coordinates");
        places.add(words.number(1, ReadingRules.PLACE));
        places.add(words.count() == 2 ? 0 : words.number(2, ReadingRules.PLACE));
    }

    void normal() throws BrokenFileException {
        requireRoom(normals.size() / 3, "normals");
        double x = words.value(1);
        double y = words.value(2);
        double z = words.value(3);
        double length = Math.hypot(Math.hypot(x, y), z);
        if (length > SHORTEST && length <= ReadingRules.LARGEST) {
            normals.add(x / length);
            normals.add(y / length);
            normals.add(z / length);
            return;
        }
        notes.count(
                "a normal without a direction was passed over; where it is named the face has its"
                        + " own",
                lines);
        withoutDirection.set(normals.size() / 3);
        for (int axis = 0; axis < 3; axis++) normals.add(axis == 0 ? 1 : 0);
    }

    /** Whether a normal's line had a direction. */
    boolean hasDirection(int normal) {
        return !withoutDirection.get(normal);
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
            notes.count("vertices without a colour, beside others with one, became white", lines);
        while (colors.size() < size) colors.add(1);
    }
}
