package rasterlab.app.canvas;

import java.awt.Dimension;
import java.awt.EventQueue;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Consumer;
import java.util.function.Predicate;
import javax.accessibility.AccessibleRole;
import javax.swing.BorderFactory;
import javax.swing.SwingUtilities;
import javax.swing.UIManager;
import rasterlab.app.canvas.work.LatestOnly;
import rasterlab.app.canvas.work.Settling;
import rasterlab.app.language.Texts;

/**
 * A plane of real coordinates as a lab's stage: grid, rulers, zoom, and points to move.
 *
 * <p>It shows what {@link #show} was given last and tells its {@link PlaneEdits} what the user
 * wants; it changes no point itself. The picture is painted on a thread of its own. The part of the
 * plane in sight stays while points are moved.
 */
public final class PlaneView extends SelfDrawn implements Settling, AutoCloseable {
    private static final long serialVersionUID = 1L;

    /** View units that an arrow key moves a point, about. */
    private static final double KEY = 4;

    /** The buttons are added first and stay above what else the stage has. */
    private static final int UNDER_BUTTONS = 1;

    private static final PlanePicture NOTHING = (g, map, colors, cancelled) -> {};

    private final PlaneAxes axes;
    private final transient PlaneEdits edits;
    private final transient Texts texts;
    private final transient Settling source;
    private final transient LatestOnly<PlaneFrame, BufferedImage> frames;
    private final ZoomButtons zoom;
    private final ReadOut pointed = new ReadOut();
    private final List<PlaneHandle> handles = new ArrayList<>();
    private transient PlanePicture picture = NOTHING;
    private transient List<PlanePoint> points = List.of();
    private transient Rectangle2D everything = new Rectangle2D.Double(0, 0, 1, 1);
    private transient Rectangle2D framed = everything;
    private transient Optional<PlaneMap> chosen = Optional.empty();
    private transient Optional<PlaneFrame> asked = Optional.empty();
    private transient Optional<BufferedImage> shown = Optional.empty();
    private String note = "";
    private String keyed = "";
    private int arrangement = Integer.MIN_VALUE;
    private double leastStep;

    /**
     * @param texts of this package
     * @param said the stage's name for assistive technology
     * @param source what the scenes come from: waited for before the picture is
     * @param onFailure told what painting threw, on any thread
     */
    public PlaneView(
            PlaneAxes axes,
            Texts texts,
            String said,
            PlaneEdits edits,
            Settling source,
            Consumer<Throwable> onFailure) {
        super(AccessibleRole.CANVAS);
        this.axes = axes;
        this.texts = texts;
        this.edits = edits;
        this.source = source;
        frames =
                new LatestOnly<>(
                        "plane picture",
                        PlaneFrame::painted,
                        (frame, image) -> EventQueue.invokeLater(() -> show(image)),
                        onFailure);
        setName("stage");
        setBorder(BorderFactory.createLineBorder(UIManager.getColor("Component.borderColor")));
        getAccessibleContext().setAccessibleName(said);
        zoom = new ZoomButtons(texts, this, new Zoom());
        add(zoom);
        add(pointed);
        var mouse = new Ground();
        addMouseListener(mouse);
        addMouseMotionListener(mouse);
        addMouseWheelListener(mouse);
    }

    /**
     * Shows a scene.
     *
     * @param note a sentence over the picture, "" for none
     * @param all what the stage shows when nobody has zoomed, in world coordinates
     * @param arranged another number than before brings {@code all} into sight
     */
    public void show(
            PlanePicture scene,
            List<PlanePoint> movable,
            String note,
            Rectangle2D all,
            int arranged) {
        picture = scene;
        this.note = note;
        everything = all;
        if (!movable.equals(points)) {
            points = List.copyOf(movable);
            showHandles();
        }
        if (arranged != arrangement) fit();
        arrangement = arranged;
        revalidate();
    }

    /**
     * Shows everything where nobody has zoomed, as after {@link #show} with another number; where
     * somebody has, only if nothing is left in sight.
     *
     * @param seen whether something is in sight, given what of the plane is, in world coordinates
     */
    public void follow(Predicate<Rectangle2D> seen) {
        if (chosen.isEmpty() || !seen.test(sight())) fit();
    }

    /** The part of the plane beside rulers and the note, in world coordinates. */
    private Rectangle2D sight() {
        Rectangle view = besideTheNote();
        PlaneMap map = map();
        var sight = new Rectangle2D.Double(map.worldX(view.x), map.worldY(view.y), 0, 0);
        sight.add(map.worldX(view.getMaxX()), map.worldY(view.getMaxY()));
        return sight;
    }

    /** Lets an arrow key move a point by at least so many world units; 0 for any step. */
    public void stepAtLeast(double worldUnits) {
        leastStep = worldUnits;
    }

    @Override
    public void settle() throws InterruptedException {
        source.settle();
        frames.settle();
    }

    /** Ends the thread that paints. */
    @Override
    public void close() {
        frames.close();
    }

    /** Gives the keyboard to the point that had it last, at first to the first one. */
    public void focusPoint() {
        handles.stream()
                .filter(handle -> handle.getName().equals(keyed))
                .findFirst()
                .or(() -> handles.stream().findFirst())
                .ifPresent(PlaneHandle::requestFocusInWindow);
    }

    /** Gives the keyboard to the added point, where there was room for one. */
    private void add(double x, double y) {
        int before = points.size();
        edits.add(x, y);
        if (points.size() <= before) return;
        points.stream()
                .min(Comparator.comparingDouble(p -> Math.hypot(p.x() - x, p.y() - y)))
                .ifPresent(nearest -> keyed = nearest.name());
        focusPoint();
    }

    /** The picture in sight, without the rings around the points, as an SVG document. */
    public SvgDrawing svg() {
        return SvgPicture.later(getWidth(), getHeight(), drawing());
    }

    /** Draws, on any thread, what {@link #svg} has. */
    public Consumer<Graphics2D> drawing() {
        PlaneFrame frame = frame(map());
        return g -> frame.paint(g, () -> false);
    }

    private void showHandles() {
        boolean focused = handles.stream().anyMatch(PlaneHandle::isFocusOwner);
        while (handles.size() > points.size()) remove(handles.remove(handles.size() - 1));
        for (int i = 0; i < points.size(); i++) {
            if (i < handles.size() && handles.get(i).getName().equals(points.get(i).name())) {
                handles.get(i).show(points.get(i));
                continue;
            }
            var handle = new PlaneHandle(points.get(i), new Handled());
            if (i < handles.size()) remove(handles.set(i, handle));
            else handles.add(handle);
            add(handle, UNDER_BUTTONS);
        }
        if (!focused || handles.isEmpty()) return;
        if (handles.stream().noneMatch(handle -> handle.getName().equals(keyed)))
            keyed = handles.get(handles.size() - 1).getName();
        focusPoint();
    }

    /** Shows everything again, and keeps doing so when the stage changes its size. */
    private void fit() {
        chosen = Optional.empty();
        framed = everything;
        revalidate();
    }

    private void zoom(double factor, Point2D view) {
        chosen = Optional.of(map().zoomed(factor, view));
        revalidate();
    }

    private PlaneMap map() {
        return chosen.orElseGet(() -> PlaneMap.fitting(framed, besideTheNote(), axes));
    }

    private Rectangle besideTheNote() {
        return PlaneFrame.note(picture, note, getSize(), PictureType.in(getSize())).below();
    }

    /** Puts the handles into their places, and asks for the picture when another is due. */
    @Override
    public void doLayout() {
        zoom.place();
        pointed.place(getHeight());
        PlaneFrame due = frame(map());
        List<Rectangle> places = due.handles();
        List<OptionalDouble> directions = due.directions();
        for (int i = 0; i < handles.size(); i++) {
            handles.get(i).setBounds(places.get(i));
            handles.get(i).point(directions.get(i));
        }
        if (asked.filter(due::equals).isPresent()) return;
        asked = Optional.of(due);
        frames.ask(due);
    }

    private PlaneFrame frame(PlaneMap map) {
        return new PlaneFrame(
                picture,
                points,
                note,
                map,
                getWidth(),
                getHeight(),
                zoom.getBounds(),
                DevicePixels.scale(this),
                StageColors.now(),
                PictureType.in(getSize()),
                texts.locale());
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

    /** Translates the mouse and the keys of handles to world coordinates. */
    private final class Handled implements PlaneHandle.DragTarget {
        @Override
        public void beginDrag() {
            edits.beginDrag();
        }

        @Override
        public void endDrag() {
            edits.endDrag();
        }

        @Override
        public void drag(PlanePoint point, Point view) {
            edits.move(point.name(), map().pointedX(view.x), map().pointedY(view.y));
        }

        @Override
        public void nudge(PlanePoint point, int right, int up) {
            double stepX = Math.max(leastStep, RoundTicks.atLeast(map().worldWidth(KEY)).step());
            double stepY = Math.max(leastStep, RoundTicks.atLeast(map().worldHeight(KEY)).step());
            double y = point.y() + (axes.up() ? up : -up) * stepY;
            edits.move(
                    point.name(),
                    right == 0 ? point.x() : RoundTicks.rounded(point.x() + right * stepX, stepX),
                    up == 0 ? point.y() : RoundTicks.rounded(y, stepY));
        }

        @Override
        public void remove(PlanePoint point) {
            edits.remove(point.name());
        }

        @Override
        public void seek() {
            fit();
        }

        @Override
        public void focused(PlaneHandle handle) {
            keyed = handle.getName();
            setComponentZOrder(handle, UNDER_BUTTONS);
            edits.select(keyed);
        }
    }

    private final class Zoom implements Zooming {
        @Override
        public void zoom(double factor, Point2D view) {
            PlaneView.this.zoom(factor, view);
        }

        @Override
        public void fit() {
            PlaneView.this.fit();
        }
    }

    /** Moves the plane by dragging its ground, zooms it by the wheel, reads off coordinates. */
    private final class Ground extends MouseAdapter {
        private Point last = new Point();

        @Override
        public void mousePressed(MouseEvent e) {
            focusPoint();
            last = e.getPoint();
            edits.beginDrag();
        }

        @Override
        public void mouseReleased(MouseEvent e) {
            edits.endDrag();
        }

        @Override
        public void mouseClicked(MouseEvent e) {
            if (e.getClickCount() == 2 && SwingUtilities.isLeftMouseButton(e))
                add(map().pointedX(e.getX()), map().pointedY(e.getY()));
        }

        @Override
        public void mouseDragged(MouseEvent e) {
            int right = e.getX() - last.x;
            int down = e.getY() - last.y;
            last = e.getPoint();
            if (edits.turn(right, down)) return;
            chosen = Optional.of(map().moved(right, down));
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
            pointed.setText(
                    Shown.point(
                            map().pointedX(e.getX()), map().pointedY(e.getY()), texts.locale()));
            pointed.setVisible(picture.ruled());
        }
    }
}
