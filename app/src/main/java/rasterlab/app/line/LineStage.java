package rasterlab.app.line;

import java.awt.Dimension;
import java.awt.EventQueue;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import java.awt.geom.Point2D;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.Stream;
import javax.accessibility.AccessibleRole;
import javax.swing.BorderFactory;
import javax.swing.SwingUtilities;
import javax.swing.UIManager;
import rasterlab.app.canvas.DevicePixels;
import rasterlab.app.canvas.EdgeArrow;
import rasterlab.app.canvas.PictureType;
import rasterlab.app.canvas.ReadOut;
import rasterlab.app.canvas.SelfDrawn;
import rasterlab.app.canvas.Shown;
import rasterlab.app.canvas.StageColors;
import rasterlab.app.canvas.SvgDrawing;
import rasterlab.app.canvas.SvgPicture;
import rasterlab.app.canvas.ZoomButtons;
import rasterlab.app.canvas.ZoomedGrid;
import rasterlab.app.canvas.Zooming;
import rasterlab.app.canvas.work.LatestOnly;
import rasterlab.app.canvas.work.Settling;
import rasterlab.app.language.Texts;
import rasterlab.engine.line.Segment;

/**
 * The zoomed pixel grid on which the segment is drawn and its ends are moved.
 *
 * <p>Pictures are painted on a thread of the stage's own; this component only shows the newest.
 */
final class LineStage extends SelfDrawn implements Settling, AutoCloseable {
    private static final long serialVersionUID = 1L;

    private final transient LineLabModel model;
    private final transient Texts texts;
    private final List<EndHandle> handles;
    private final ZoomButtons zoom;
    private final ReadOut pointed = new ReadOut();
    private final transient LatestOnly<LineFrame, BufferedImage> frames;
    private transient Optional<LineFrame> asked = Optional.empty();
    private transient Optional<BufferedImage> shown = Optional.empty();
    private transient Optional<ZoomedGrid> chosen = Optional.empty();

    /** The grid under the pointer while an end is dragged. */
    private transient Optional<ZoomedGrid> held = Optional.empty();

    /** The pixels in sight where nobody has zoomed. */
    private transient Rectangle framed;

    private transient Segment seen;
    private transient Optional<TrialSegment> program = Optional.empty();
    private End keyed = End.A;
    private int arrangement;

    /**
     * @param onFailure told what painting threw, on any thread
     */
    LineStage(LineLabModel model, Texts texts, Consumer<Throwable> onFailure) {
        super(AccessibleRole.CANVAS);
        this.model = model;
        this.texts = texts;
        frames =
                new LatestOnly<>(
                        "line picture",
                        LineFrame::painted,
                        (frame, image) -> EventQueue.invokeLater(() -> show(image)),
                        onFailure);
        setName("stage");
        setBorder(BorderFactory.createLineBorder(UIManager.getColor("Component.borderColor")));
        getAccessibleContext().setAccessibleName(texts.text("stage"));
        handles = List.of(handle(End.A), handle(End.B));
        zoom = new ZoomButtons(Texts.of("canvas", texts.language()), this, new Zoom());
        add(zoom, 0); // Above the handles.
        add(pointed);
        var mouse = new Pan();
        addMouseListener(mouse);
        addMouseMotionListener(mouse);
        addMouseWheelListener(mouse);
        arrangement = model.state().arrangement();
        seen = model.state().choice().segment();
        framed = LineFraming.of(model.state());
    }

    @Override
    public void settle() throws InterruptedException {
        model.settle();
        frames.settle();
    }

    /** Ends the thread that paints. */
    @Override
    public void close() {
        frames.close();
    }

    private EndHandle handle(End end) {
        var handle = new EndHandle[1];
        handle[0] =
                new EndHandle(
                        end,
                        model,
                        point -> {
                            Point view = SwingUtilities.convertPoint(handle[0], point, this);
                            held = held.or(() -> Optional.of(grid()));
                            Point pixel = grid().pixelAt(view.x, view.y);
                            model.moveEnd(end, pixel.x, pixel.y);
                        },
                        this::release,
                        this::fit);
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

    /** Leaves the grid where it was while the end was dragged. */
    private void release() {
        held.filter(grid -> !grid.equals(fitting(sight()))).ifPresent(this::keep);
        held = Optional.empty();
        revalidate();
    }

    private void keep(ZoomedGrid grid) {
        chosen = Optional.of(grid);
    }

    /** Gives the keyboard to the end that had it last, at first to A. */
    void focusEnd() {
        handles.get(keyed.ordinal()).requestFocusInWindow();
    }

    /** Shows the model's present state. */
    void refresh() {
        LineLabState state = model.state();
        if (state.arrangement() != arrangement) fit();
        else if (!state.drawings().tried().equals(program)) reframe();
        else if (held.isEmpty() && isLost(state.choice().segment())) reframe();
        arrangement = state.arrangement();
        seen = state.choice().segment();
        program = state.drawings().tried();
        revalidate();
    }

    /** Whether an end that was in another pixel before is out of sight, where nobody has zoomed. */
    private boolean isLost(Segment segment) {
        if (segment.equals(seen) || chosen.isPresent()) return false;
        ZoomedGrid grid = grid();
        return Stream.of(End.values())
                .filter(end -> end.x(segment) != end.x(seen) || end.y(segment) != end.y(seen))
                .anyMatch(end -> !sight().contains(LineFrame.middle(end, segment, grid)));
    }

    private void reframe() {
        framed = LineFraming.of(model.state());
    }

    /** Shows the whole segment again, and keeps doing so when the stage changes its size. */
    private void fit() {
        chosen = Optional.empty();
        reframe();
        revalidate();
    }

    private void zoom(double factor, Point2D view) {
        chosen = Optional.of(grid().zoomed(factor, view));
        held = held.flatMap(grid -> chosen);
        revalidate();
    }

    private ZoomedGrid grid() {
        return grid(sight());
    }

    private ZoomedGrid grid(Rectangle sight) {
        return held.or(() -> chosen).orElseGet(() -> fitting(sight));
    }

    private ZoomedGrid fitting(Rectangle sight) {
        return chosen.orElseGet(() -> ZoomedGrid.fitting(framed, sight));
    }

    /** The part of the stage that rulers and the note leave free. */
    private Rectangle sight() {
        return LineFrame.note(note(), getSize(), PictureType.in(getSize())).below();
    }

    private String note() {
        return LineNotes.about(model.state().drawings(), texts).orElse("");
    }

    /**
     * Puts the handles around their ends, one whose end is out of sight at the edge, and asks for
     * the picture when another is due.
     */
    @Override
    public void doLayout() {
        zoom.place();
        pointed.place(getHeight());
        Segment segment = model.state().choice().segment();
        Rectangle sight = sight();
        ZoomedGrid grid = grid(sight);
        for (End end : End.values()) {
            EndHandle handle = handles.get(end.ordinal());
            Rectangle place = LineFrame.around(end, segment, grid, sight, zoom.getBounds());
            handle.setBounds(place);
            handle.point(
                    EdgeArrow.towards(
                            LineFrame.middle(end, segment, grid), place, sight, zoom.getBounds()),
                    texts.text("end.away", end.name()));
            handle.getAccessibleContext()
                    .setAccessibleName(
                            texts.text(
                                    "end",
                                    end.name(),
                                    Shown.point(end.x(segment), end.y(segment), texts.locale())));
        }
        LineFrame due = frame(grid);
        if (asked.filter(due::equals).isPresent()) return;
        asked = Optional.of(due);
        frames.ask(due);
    }

    private LineFrame frame(ZoomedGrid grid) {
        LineLabState state = model.state();
        return new LineFrame(
                state.drawings(),
                state.step(),
                grid,
                getWidth(),
                getHeight(),
                DevicePixels.scale(this),
                StageColors.now(),
                PictureType.in(getSize()),
                note(),
                zoom.getBounds(),
                texts.locale());
    }

    /** The picture without the rings around the ends, as an SVG document. */
    SvgDrawing svg() {
        LineFrame frame = frame(grid());
        return SvgPicture.later(getWidth(), getHeight(), g -> frame.paint(g, () -> false));
    }

    private void show(BufferedImage image) {
        shown = Optional.of(image);
        repaint();
    }

    @Override
    public Dimension getPreferredSize() {
        return new Dimension(800, 560);
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        var g = (Graphics2D) graphics.create();
        g.setColor(StageColors.now().ground());
        g.fillRect(0, 0, getWidth(), getHeight());
        shown.ifPresent(image -> DevicePixels.paint(g, image));
        g.dispose();
    }

    private final class Zoom implements Zooming {
        @Override
        public void zoom(double factor, Point2D view) {
            LineStage.this.zoom(factor, view);
        }

        @Override
        public void fit() {
            LineStage.this.fit();
        }
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
            pointed.setVisible(false);
        }

        @Override
        public void mouseWheelMoved(MouseWheelEvent e) {
            zoom(ZoomButtons.factor(e.getPreciseWheelRotation()), e.getPoint());
        }

        private void point(MouseEvent e) {
            Point pixel = grid().pixelAt(e.getX(), e.getY());
            pointed.setText(Shown.point(pixel.x, pixel.y, texts.locale()));
            pointed.setVisible(true);
        }
    }
}
