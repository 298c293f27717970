package rasterlab.app.clip;

import java.awt.Dimension;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.JPanel;
import rasterlab.app.canvas.PlaneAxes;
import rasterlab.app.canvas.PlaneEdits;
import rasterlab.app.canvas.PlanePoint;
import rasterlab.app.canvas.PlaneView;
import rasterlab.app.canvas.Shown;
import rasterlab.app.canvas.SvgDrawing;
import rasterlab.app.canvas.SvgPicture;
import rasterlab.app.canvas.method.OwnWords;
import rasterlab.app.clip.outcome.ClipResults;
import rasterlab.app.clip.outcome.Clipping;
import rasterlab.app.clip.outcome.Codes;
import rasterlab.app.clip.outcome.SegmentClipping;
import rasterlab.app.clip.scene.ClipGrip;
import rasterlab.app.clip.scene.ClipMode;
import rasterlab.app.clip.scene.ClipPoint;
import rasterlab.app.clip.scene.ClipScene;
import rasterlab.app.clip.scene.SegmentScene;
import rasterlab.app.clip.scene.SpacePoint;
import rasterlab.app.clip.scene.VolumeScene;
import rasterlab.app.language.Texts;

/** The picture of the chosen method, and beside it that of a second one. */
final class ClipStage extends JPanel implements AutoCloseable {
    private static final long serialVersionUID = 1L;

    /** Degrees that one view unit of a drag turns. */
    private static final double TURN = 0.5;

    /** View units between the two pictures. */
    private static final int GAP = 8;

    private final transient ClipLabModel model;
    private final transient Texts texts;
    private final PlaneView chosen;
    private final PlaneView other;

    /**
     * @param onFailure told what painting threw, on any thread
     */
    ClipStage(ClipLabModel model, Texts texts, Consumer<Throwable> onFailure) {
        super(null);
        this.model = model;
        this.texts = texts;
        setOpaque(false);
        chosen = view("stage", onFailure);
        other = view("stage.other", onFailure);
        add(chosen);
        add(other);
        refresh();
    }

    private PlaneView view(String name, Consumer<Throwable> onFailure) {
        var view =
                new PlaneView(
                        PlaneAxes.GEOMETRY,
                        Texts.of("canvas", texts.language()),
                        texts.text(name),
                        new Edits(),
                        model::settle,
                        onFailure);
        view.setName(name);
        return view;
    }

    /**
     * Places the pictures beside each other or one above the other, whichever shows everything
     * larger.
     */
    @Override
    public void doLayout() {
        int width = getWidth();
        int height = getHeight();
        if (!other.isVisible()) {
            chosen.setBounds(0, 0, width, height);
            return;
        }
        Rectangle2D all = everything();
        double beside = Math.min(width / 2.0 / all.getWidth(), height / all.getHeight());
        double above = Math.min(width / all.getWidth(), height / 2.0 / all.getHeight());
        int halfWidth = (width - GAP) / 2;
        int halfHeight = (height - GAP) / 2;
        if (beside >= above) {
            chosen.setBounds(0, 0, halfWidth, height);
            other.setBounds(width - halfWidth, 0, halfWidth, height);
        } else {
            chosen.setBounds(0, 0, width, halfHeight);
            other.setBounds(0, height - halfHeight, width, halfHeight);
        }
    }

    @Override
    public Dimension getPreferredSize() {
        return chosen.getPreferredSize();
    }

    /** Gives the keyboard to the point that had it last. */
    void focusPoint() {
        chosen.focusPoint();
    }

    SvgDrawing svg() {
        return SvgPicture.of(this, chosen, other);
    }

    /** Ends the threads that paint. */
    @Override
    public void close() {
        chosen.close();
        other.close();
    }

    /** Shows the model's present state. */
    void refresh() {
        ClipLabState state = model.state();
        ClipResults results = state.results();
        Optional<Clipping> second =
                state.choice().difference() ? Optional.empty() : results.other();
        chosen.show(
                ClipPicture.first(state, texts.locale()),
                points(),
                note(results.clipping(), state.finished(), second.isPresent()),
                everything(),
                state.arrangement());
        boolean beside = second.isPresent();
        if (beside != other.isVisible()) {
            other.setVisible(beside);
            revalidate();
        }
        second.ifPresent(clipping -> showOther(state, clipping));
    }

    private void showOther(ClipLabState state, Clipping clipping) {
        int step = state.finished() ? clipping.steps().size() + 1 : state.step();
        boolean finished = step > clipping.steps().size();
        other.show(
                ClipPicture.of(state.results().scene(), clipping, step, texts.locale()),
                List.of(),
                note(clipping, finished, true),
                everything(),
                state.arrangement());
    }

    /** A note on what the picture alone would not tell; with two pictures also whose each is. */
    private String note(Clipping clipping, boolean finished, boolean named) {
        ClipScene scene = model.state().results().scene();
        String note = finished ? ClipNotes.about(scene, clipping, texts) : "";
        return note.isEmpty() && named
                ? OwnWords.called(clipping.method(), texts.language())
                : note;
    }

    private Rectangle2D everything() {
        return ClipFraming.of(model.state().choice().scene());
    }

    private List<PlanePoint> points() {
        var points = new ArrayList<PlanePoint>();
        ClipScene scene = model.state().choice().scene();
        scene.grips()
                .forEach(
                        (grip, at) -> {
                            if (at.isFinite()) points.add(point(scene, grip, at));
                        });
        return points;
    }

    private PlanePoint point(ClipScene scene, ClipGrip grip, ClipPoint at) {
        String kind = "grip." + grip.kind().name().toLowerCase(Locale.ROOT);
        String said = texts.text(kind, grip.label()) + " " + accessibleText(scene, grip, at);
        return new PlanePoint(
                grip.componentName(),
                at.x(),
                at.y(),
                form(grip),
                label(scene, grip),
                texts.text("grip.keys", said));
    }

    private String accessibleText(ClipScene scene, ClipGrip grip, ClipPoint at) {
        if (!(scene instanceof VolumeScene volume))
            return Shown.point(at.x(), at.y(), texts.locale());
        SpacePoint p = volume.end(grip);
        return "("
                + Shown.number(p.x(), texts.locale())
                + "; "
                + Shown.number(p.y(), texts.locale())
                + "; "
                + Shown.number(p.z(), texts.locale())
                + ")";
    }

    private static PlanePoint.HandleShape form(ClipGrip grip) {
        return switch (grip.kind()) {
            case WINDOW -> PlanePoint.HandleShape.SQUARE;
            case CORNER -> PlanePoint.HandleShape.DIAMOND;
            case END -> PlanePoint.HandleShape.CIRCLE;
        };
    }

    /** An end with its region code; corners are told apart by their place alone. */
    private static String label(ClipScene scene, ClipGrip grip) {
        if (grip.kind() == ClipGrip.ClipGripKind.WINDOW) return "";
        if (grip.kind() == ClipGrip.ClipGripKind.CORNER) return grip.label();
        if (scene instanceof VolumeScene volume)
            return grip.label() + " " + Codes.bits(ClipReadings.code(volume, volume.end(grip)), 6);
        var plane = (SegmentScene) scene;
        return plane.window().upright()
                ? grip.label()
                        + " "
                        + Codes.bits(SegmentClipping.codes(plane, grip.index())[grip.end()], 4)
                : grip.label();
    }

    /** Passes what mouse and keyboard do on to the model. */
    private final class Edits implements PlaneEdits {
        @Override
        public void beginDrag() {
            model.beginDrag();
        }

        @Override
        public void endDrag() {
            model.endDrag();
        }

        @Override
        public void move(String point, double x, double y) {
            grip(point).ifPresent(grip -> model.move(grip, x, y));
        }

        @Override
        public void select(String point) {
            grip(point).ifPresent(model::select);
        }

        @Override
        public void remove(String point) {
            grip(point).ifPresent(model::select);
            model.shrink();
        }

        @Override
        public boolean turn(int viewRight, int viewDown) {
            if (model.state().choice().mode() != ClipMode.VOLUME) return false;
            model.volume(
                    old -> old.withView(old.view().turned(-viewRight * TURN, -viewDown * TURN)));
            return true;
        }

        private Optional<ClipGrip> grip(String name) {
            return model.state().choice().scene().grips().keySet().stream()
                    .filter(each -> each.componentName().equals(name))
                    .findFirst();
        }
    }
}
