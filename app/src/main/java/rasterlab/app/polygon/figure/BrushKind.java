package rasterlab.app.polygon.figure;

import java.util.List;
import java.util.Locale;
import rasterlab.engine.naming.Named;
import rasterlab.engine.surface.Brush;

/** The paint of a polygon's pixels: one colour, a hatch, or a pattern. */
public enum BrushKind {
    SOLID,
    ROWS,
    COLUMNS,
    FALLING,
    RISING,
    CROSS,
    DIAGONAL_CROSS,
    BRICKS,
    CHECKS;

    private static final int SPACING = 4;

    /** One character a pixel; # is painted. */
    private static final String[] WALL = {
        "########",
        "#.......",
        "#.......",
        "#.......",
        "########",
        "....#...",
        "....#...",
        "....#..."
    };

    private static final String[] BOARD = {"##..", "##..", "..##", "..##"};

    /** A brush of that colour; pixels between its lines stay clear. */
    public Brush brush(int argb) {
        return switch (this) {
            case SOLID -> Brush.solid(argb);
            case ROWS -> Brush.rows(argb, SPACING);
            case COLUMNS -> Brush.columns(argb, SPACING);
            case FALLING -> Brush.falling(argb, SPACING);
            case RISING -> Brush.rising(argb, SPACING);
            case CROSS -> Brush.rows(argb, SPACING).over(Brush.columns(argb, SPACING));
            case DIAGONAL_CROSS -> Brush.falling(argb, SPACING).over(Brush.rising(argb, SPACING));
            case BRICKS -> Brush.pattern(tile(argb, WALL));
            case CHECKS -> Brush.pattern(tile(argb, BOARD));
        };
    }

    private static int[][] tile(int argb, String... rows) {
        var tile = new int[rows.length][];
        for (int y = 0; y < rows.length; y++)
            tile[y] = rows[y].chars().map(c -> c == '#' ? argb : Brush.CLEAR).toArray();
        return tile;
    }

    public String code() {
        return name().toLowerCase(Locale.ROOT);
    }

    public static BrushKind coded(String code) {
        return Named.find("brush", code, List.of(values()), BrushKind::code);
    }
}
