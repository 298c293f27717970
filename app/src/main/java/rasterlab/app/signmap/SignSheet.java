package rasterlab.app.signmap;

import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import rasterlab.app.canvas.SvgPicture;
import rasterlab.app.canvas.Wrapping;
import rasterlab.app.chart.ChartLook;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.signmap.SignPainter.DotMeaning;
import rasterlab.engine.signmap.SignMap;

/** Sign maps side by side, each with its name and the share that is wrong, above one legend. */
public final class SignSheet {
    /** Dots across. */
    public static final int WIDTH = 1000;

    private static final int MARGIN = 24;
    private static final int TOP = 64;
    private static final int COLUMNS = 3;

    /** Dots across one of several maps; a whole number for each point. */
    private static final int SIDE = 256;

    private static final int GAP = 68;
    private static final int LINE = 18;
    private static final int SWATCH = 18;
    private static final Font PLAIN = new Font(Font.SANS_SERIF, Font.PLAIN, 13);
    private static final Font BOLD = new Font(Font.SANS_SERIF, Font.BOLD, 14);
    private static final Font TITLE = new Font(Font.SANS_SERIF, Font.BOLD, 18);

    private final List<SignMap> maps;
    private final Texts texts;
    private final SignWords words;
    private final List<String> notes;
    private final ChartLook look;
    private final SignPainter painter;

    public SignSheet(List<SignMap> maps, Language language, ChartLook look) {
        this.maps = List.copyOf(maps);
        texts = Texts.of("signmap", language);
        words = new SignWords(texts);
        notes = notes();
        this.look = look;
        painter = new SignPainter(look);
    }

    /** Dots across a map: one alone is twice as large. */
    private int side() {
        return maps.size() == 1 ? 2 * SIDE : SIDE;
    }

    private int rows() {
        return (maps.size() + COLUMNS - 1) / COLUMNS;
    }

    /** Height of a map with the words below it, in dots. */
    private int tile() {
        return side() + 3 * LINE + 14;
    }

    public int height() {
        int legend = (legend().size() + 1) / 2 * (LINE + 8);
        return TOP + rows() * tile() + legend + notes.size() * LINE + 16;
    }

    /** The lines below the legend: the inputs that repeat each map, then how maps are read. */
    private List<String> notes() {
        Graphics2D g = new BufferedImage(1, 1, BufferedImage.TYPE_INT_RGB).createGraphics();
        FontMetrics metrics = g.getFontMetrics(PLAIN);
        var all = new ArrayList<>(words.inputs(maps));
        all.add(texts.text("note"));
        List<String> lines =
                all.stream()
                        .flatMap(
                                one ->
                                        Wrapping.lines(
                                                one, WIDTH - 2 * MARGIN, metrics::stringWidth)
                                                .stream())
                        .toList();
        g.dispose();
        return lines;
    }

    /** The sheet as a picture. */
    public BufferedImage image() {
        var image = new BufferedImage(WIDTH, height(), BufferedImage.TYPE_INT_RGB);
        Graphics2D g = image.createGraphics();
        g.setRenderingHint(
                RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        paint(g);
        g.dispose();
        return image;
    }

    /** The sheet as an SVG document. */
    public byte[] svg() {
        return SvgPicture.of(WIDTH, height(), this::paint)
                .document()
                .getBytes(StandardCharsets.UTF_8);
    }

    private void paint(Graphics2D g) {
        g.setColor(look.ground());
        g.fillRect(0, 0, WIDTH, height());
        g.setColor(look.ink());
        g.setFont(TITLE);
        g.drawString(texts.text("title"), MARGIN, 38);
        for (int i = 0; i < maps.size(); i++)
            paint(g, maps.get(i), MARGIN + i % COLUMNS * (SIDE + GAP), TOP + i / COLUMNS * tile());
        paintLegend(g, TOP + rows() * tile());
    }

    private void paint(Graphics2D g, SignMap map, int x, int y) {
        g.drawImage(painter.image(map, side() / map.size()), x, y, null);
        g.setColor(look.note());
        g.drawRect(x - 1, y - 1, side() + 1, side() + 1);
        int base = y + side() + LINE;
        g.setFont(BOLD);
        g.setColor(look.ink());
        g.drawString(map.subject() + " " + map.method(), x, base);
        g.setFont(PLAIN);
        g.drawString(words.share(map), x, base + LINE);
        g.setColor(look.note());
        g.drawString(
                texts.text("place." + map.spacing().code(), map.x(0), map.y(0)),
                x,
                base + 2 * LINE);
    }

    private List<DotMeaning> legend() {
        boolean signs = maps.stream().anyMatch(map -> !map.yesOrNo());
        boolean none = maps.stream().anyMatch(map -> map.unanswered() > 0);
        var dots =
                new ArrayList<DotMeaning>(
                        List.of(
                                DotMeaning.PLUS,
                                DotMeaning.MINUS,
                                DotMeaning.EXTRA,
                                DotMeaning.MISSING));
        if (signs) dots.add(2, DotMeaning.ZERO);
        if (none) dots.add(DotMeaning.NONE);
        return dots;
    }

    private void paintLegend(Graphics2D g, int top) {
        List<DotMeaning> dots = legend();
        int column = (WIDTH - 2 * MARGIN) / 2;
        g.setFont(PLAIN);
        for (int i = 0; i < dots.size(); i++) {
            int x = MARGIN + i % 2 * column;
            int y = top + i / 2 * (LINE + 8);
            g.drawImage(swatch(dots.get(i)), x, y, null);
            g.setColor(look.note());
            g.drawRect(x, y, 2 * SWATCH - 1, SWATCH - 1);
            g.setColor(look.ink());
            g.drawString(words(dots.get(i)), x + 2 * SWATCH + 8, y + 14);
        }
        int y = top + (dots.size() + 1) / 2 * (LINE + 8) + LINE;
        g.setColor(look.note());
        for (String line : notes) {
            g.drawString(line, MARGIN, y);
            y += LINE;
        }
    }

    private BufferedImage swatch(DotMeaning dot) {
        var image = new BufferedImage(2 * SWATCH, SWATCH, BufferedImage.TYPE_INT_RGB);
        for (int y = 0; y < SWATCH; y++)
            for (int x = 0; x < 2 * SWATCH; x++)
                image.setRGB(x, y, painter.color(dot, x, y).getRGB());
        return image;
    }

    private String words(DotMeaning dot) {
        boolean yes = maps.stream().allMatch(SignMap::yesOrNo);
        boolean signs = maps.stream().noneMatch(SignMap::yesOrNo);
        String asked = yes ? ".asked" : signs ? ".sign" : ".both";
        return switch (dot) {
            case PLUS -> texts.text("plus" + asked);
            case MINUS -> texts.text("minus" + asked);
            case ZERO -> texts.text("zero");
            case EXTRA -> texts.text("extra" + asked);
            case MISSING -> texts.text("missing" + asked);
            case NONE -> texts.text("none");
        };
    }
}
