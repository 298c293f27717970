package rasterlab.app.line;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Color;
import java.awt.Dimension;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.RenderingHints;
import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import java.awt.geom.Point2D;
import java.util.List;
import java.util.Optional;
import javax.accessibility.AccessibleRole;
import javax.swing.BorderFactory;
import javax.swing.KeyStroke;
import javax.swing.SwingUtilities;
import javax.swing.UIManager;
import rasterlab.app.canvas.KeyBinding;
import rasterlab.app.canvas.PixelGrid;
import rasterlab.app.canvas.Rulers;
import rasterlab.app.canvas.SelfDrawn;
import rasterlab.app.canvas.StageColours;
import rasterlab.app.canvas.Wrapping;
import rasterlab.app.canvas.ZoomButtons;
import rasterlab.app.language.Texts;
import rasterlab.engine.line.Segment;

/** The zoomed pixel grid on which the segment is drawn and its ends are moved. */
final class LineStage extends SelfDrawn {
    private static final long serialVersionUID = 1L;

    private static final double ZOOM = 1.25;

    private final transient LineLabModel model;
    private final transient Texts texts;
    private final List<EndHandle> handles;
    private final ZoomButtons zoom;
    private transient Optional<PixelGrid> chosen = Optional.empty();
    private transient Optional<Point> pointed = Optional.empty();
    private End keyed = End.A;
    private int arrangement;

    LineStage(LineLabModel model, Texts texts) {
        super(AccessibleRole.CANVAS);
        this.model = model;
        this.texts = texts;
        setName("stage");
        setBorder(BorderFactory.createLineBorder(UIManager.getColor("Component.borderColor")));
        getAccessibleContext().setAccessibleName(texts.text("stage"));
        handles = List.of(handle(End.A), handle(End.B));
        zoom =
                new ZoomButtons(
                        Texts.of("canvas", texts.language()),
                        this::zoomIn,
                        this::zoomOut,
                        this::fit);
        add(zoom);
        var mouse = new Pan();
        addMouseListener(mouse);
        addMouseMotionListener(mouse);
        addMouseWheelListener(mouse);
        for (String key : List.of("typed +", "typed ="))
            KeyBinding.within(this, KeyStroke.getKeyStroke(key), this::zoomIn);
        KeyBinding.within(this, KeyStroke.getKeyStroke("typed -"), this::zoomOut);
        KeyBinding.within(this, KeyStroke.getKeyStroke("typed 0"), this::fit);
        arrangement = model.state().arrangement();
    }

    private EndHandle handle(End end) {
        var handle = new EndHandle[1];
        handle[0] =
                new EndHandle(
                        end,
                        model,
                        point -> {
                            Point view = SwingUtilities.convertPoint(handle[0], point, this);
                            Point pixel = grid().pixelAt(view.x, view.y);
                            model.moveEnd(end, pixel.x, pixel.y);
                        });
        handle[0].addFocusListener(
                new FocusAdapter() {
                    @Override
                    public void focusGained(FocusEvent e) {
                        keyed = end;
                    }
                });
        add(handle[0]);
        return handle[0];
    }

    /** Gives the keyboard to the end that had it last, at first to A. */
    void focusEnd() {
        handles.get(keyed.ordinal()).requestFocusInWindow();
    }

    /** Shows the model's present state. */
    void refresh() {
        LineLabState state = model.state();
        if (state.arrangement() != arrangement) fit();
        arrangement = state.arrangement();
        revalidate();
        repaint();
    }

    private void zoomIn() {
        zoom(ZOOM, centre());
    }

    private void zoomOut() {
        zoom(1 / ZOOM, centre());
    }

    /** Shows the whole segment again, and keeps doing so when the stage changes its size. */
    private void fit() {
        chosen = Optional.empty();
        revalidate();
        repaint();
    }

    private void zoom(double factor, Point2D view) {
        chosen = Optional.of(grid().zoomed(factor, view));
        revalidate();
        repaint();
    }

    private PixelGrid grid() {
        return chosen.orElseGet(() -> LineFraming.of(model.state(), Rulers.inside(getSize())));
    }

    private Point2D centre() {
        Rectangle inside = Rulers.inside(getSize());
        return new Point2D.Double(inside.getCenterX(), inside.getCenterY());
    }

    /** Puts the handles around their ends; one whose end is out of sight waits at the edge. */
    @Override
    public void doLayout() {
        Dimension corner = zoom.getPreferredSize();
        zoom.setBounds(
                getWidth() - corner.width - 8,
                getHeight() - corner.height - 8,
                corner.width,
                corner.height);
        PixelGrid grid = grid();
        Segment segment = model.state().choice().segment();
        int size = (int) Math.max(UIScale.scale(26), Math.min(60, grid.cell() * 1.5 + 6));
        for (End end : End.values()) {
            EndHandle handle = handles.get(end.ordinal());
            handle.setBounds(
                    within(grid.viewX(end.x(segment)), Rulers.left(), getWidth(), size),
                    within(grid.viewY(end.y(segment)), Rulers.top(), getHeight(), size),
                    size,
                    size);
            handle.getAccessibleContext()
                    .setAccessibleName(
                            texts.text("end", end.name(), end.x(segment), end.y(segment)));
        }
    }

    /** Where a handle of that size begins, so that its middle is at {@code view} if it fits. */
    private static int within(double view, int from, int to, int size) {
        return (int) Math.round(Math.max(from, Math.min(to - size, view - size / 2.0)));
    }

    @Override
    public Dimension getPreferredSize() {
        return new Dimension(800, 560);
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        var g = (Graphics2D) graphics.create();
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        g.setRenderingHint(
                RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        g.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
        g.setFont(UIManager.getFont("Label.font"));
        StageColours colours = StageColours.now();
        PixelGrid grid = grid();
        var rulers = new Rulers(grid, getSize(), colours);
        rulers.paintGrid(g);
        new LinePainter(g, grid, colours).paint(model.state());
        paintLetters(g, grid, colours);
        rulers.paintMargins(g);
        LineNotes.about(model.state(), texts).ifPresent(text -> paintNote(g, colours, text));
        pointed.ifPresent(
                pixel ->
                        plate(
                                g,
                                colours,
                                "(" + pixel.x + ", " + pixel.y + ")",
                                Rulers.left() + 10,
                                getHeight() - 10));
        g.dispose();
    }

    /** The ends' letters and coordinates, outside the segment. */
    private void paintLetters(Graphics2D g, PixelGrid grid, StageColours colours) {
        Segment segment = model.state().choice().segment();
        g.setFont(UIManager.getFont("Label.font").deriveFont(Font.BOLD));
        FontMetrics metrics = g.getFontMetrics();
        for (End end : End.values()) {
            String text = end + " (" + end.x(segment) + ", " + end.y(segment) + ")";
            Rectangle handle = handles.get(end.ordinal()).getBounds();
            int width = metrics.stringWidth(text);
            int x = handle.x + (handle.width - width) / 2;
            boolean above = (end == End.A) == (segment.y0() <= segment.y1());
            int y = above ? handle.y - 8 : handle.y + handle.height + metrics.getAscent() + 6;
            plate(
                    g,
                    colours,
                    text,
                    Math.max(Rulers.left() + 8, Math.min(getWidth() - width - 10, x)),
                    Math.max(
                            Rulers.top() + metrics.getAscent() + 6, Math.min(getHeight() - 10, y)));
        }
    }

    /** A sentence in the middle of the stage's upper edge, wrapped to its width. */
    private void paintNote(Graphics2D g, StageColours colours, String sentence) {
        g.setFont(UIManager.getFont("Label.font").deriveFont(Font.BOLD));
        FontMetrics metrics = g.getFontMetrics();
        int y = Rulers.top() + metrics.getAscent() + 12;
        int room = getWidth() - Rulers.left() - 32;
        for (String line : Wrapping.lines(sentence, room, metrics::stringWidth)) {
            plate(g, colours, line, Rulers.left() + 16, y);
            y += metrics.getHeight() + 2;
        }
    }

    private static void plate(Graphics2D g, StageColours colours, String text, int x, int y) {
        FontMetrics metrics = g.getFontMetrics();
        Color ground = colours.ground();
        g.setColor(new Color(ground.getRed(), ground.getGreen(), ground.getBlue(), 225));
        g.fillRoundRect(
                x - 5,
                y - metrics.getAscent() - 2,
                metrics.stringWidth(text) + 10,
                metrics.getHeight() + 3,
                8,
                8);
        g.setColor(colours.ink());
        g.drawString(text, x, y);
    }

    /** Moves the grid by dragging its ground, zooms it by the wheel, reads off pixels. */
    private final class Pan extends MouseAdapter {
        private Point last = new Point();

        @Override
        public void mousePressed(MouseEvent e) {
            focusEnd();
            last = e.getPoint();
        }

        @Override
        public void mouseDragged(MouseEvent e) {
            chosen = Optional.of(grid().moved(e.getX() - last.x, e.getY() - last.y));
            last = e.getPoint();
            revalidate();
            point(e);
        }

        @Override
        public void mouseMoved(MouseEvent e) {
            point(e);
        }

        @Override
        public void mouseExited(MouseEvent e) {
            pointed = Optional.empty();
            repaint();
        }

        @Override
        public void mouseWheelMoved(MouseWheelEvent e) {
            zoom(Math.pow(ZOOM, -e.getPreciseWheelRotation()), e.getPoint());
        }

        private void point(MouseEvent e) {
            pointed = Optional.of(grid().pixelAt(e.getX(), e.getY()));
            repaint();
        }
    }
}
