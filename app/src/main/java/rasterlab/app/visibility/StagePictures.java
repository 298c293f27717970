package rasterlab.app.visibility;

import java.util.List;
import java.util.Optional;
import rasterlab.app.mine.OwnMethods;
import rasterlab.app.visibility.scene.SceneReach;
import rasterlab.app.visibility.scene.StageView;
import rasterlab.app.visibility.scene.VisibilityChoice;
import rasterlab.engine.pipeline.RenderRequest;
import rasterlab.engine.study.Method;
import rasterlab.engine.transform.PictureFit;
import rasterlab.engine.visibility.Visibility;
import rasterlab.engine.visibility.buffer.DepthBuffer;

/**
 * The pictures for a choice on a stage of some size.
 *
 * @param own draws by the user's own program
 * @param width device pixels; 0 before the size is known
 * @param height device pixels
 */
record StagePictures(List<Method<Visibility>> methods, Visibility own, int width, int height) {
    /** View pixels between two pictures. */
    static final int GAP = 6;

    /** The most that a scene takes of the narrower side of one of two pictures. */
    private static final double FILLED = 0.94;

    boolean known() {
        return width > 0;
    }

    StagePictures sized(int newWidth, int newHeight) {
        return new StagePictures(methods, own, newWidth, newHeight);
    }

    StagePictures withOwn(Visibility other) {
        return new StagePictures(methods, other, width, height);
    }

    /** Whether the method can draw the faces' edges. */
    boolean canDrawEdges(String name) {
        if (name.equals(OwnMethods.NAME)) return own.drawsOutlines();
        return methods.stream()
                .filter(method -> method.name().equals(name))
                .anyMatch(method -> method.implementation().drawsOutlines());
    }

    /** Whether a picture by that method has edges. */
    boolean drawsEdges(VisibilityChoice choice, String method) {
        return choice.edges() && canDrawEdges(method) && !choice.shading().equals("wire");
    }

    /** Whether the chosen method's steps are watched: not while another's depths are shown. */
    boolean watchesSteps(VisibilityChoice choice) {
        return choice.drawing()
                && (choice.view() != StageView.DEPTHS || keepsDepths(choice.visibility()));
    }

    private boolean keepsDepths(String name) {
        return methods.stream()
                .filter(method -> method.name().equals(name))
                .anyMatch(method -> DepthBuffer.keptBy(method.implementation()));
    }

    /** Two share the stage. */
    private int pictureWidth(VisibilityChoice choice) {
        return choice.comparison().isEmpty() ? width : Math.max(1, (width - GAP) / 2);
    }

    private static Optional<String> second(VisibilityChoice choice) {
        return Optional.of(choice.comparison()).filter(method -> !method.isEmpty());
    }

    /**
     * The choice with a scene as large as it is shown: of two pictures that are higher than wide,
     * each is filled at the scene's usual zoom by what, however it is turned, has room there.
     */
    VisibilityChoice filling(VisibilityChoice choice) {
        int wide = pictureWidth(choice);
        double usual = PictureFit.of(wide, height, 1).pixelsPerUnit();
        double most = (double) height / PictureFit.NATURAL_HEIGHT / usual;
        if (choice.comparison().isEmpty() || most <= 1) return choice;
        double reach = usual * choice.usualZoom() * SceneReach.of(choice);
        double room = FILLED * Math.min(wide, height) / 2 / reach;
        return room <= 1 ? choice : choice.zoomed(Math.min(most, room));
    }

    RenderRequest request(VisibilityChoice choice, String method) {
        RenderRequest plain = plain(filling(choice), method, pictureWidth(choice));
        return drawsEdges(choice, method) ? plain.withOutline() : plain;
    }

    /** The picture without edges, which the user's own program draws by itself. */
    private RenderRequest plain(VisibilityChoice shown, String method, int wide) {
        RenderRequest plain = shown.plain(method, wide, height);
        return method.equals(OwnMethods.NAME)
                ? plain.with(plain.look().withVisibility(method, own))
                : plain;
    }

    /**
     * @param step after which the picture is shown, where the steps are watched
     */
    Frame frame(VisibilityChoice choice, int step) {
        return new Frame(
                request(choice, choice.visibility()),
                second(choice).map(method -> request(choice, method)),
                choice.view() == StageView.DEPTHS,
                watchesSteps(choice) ? step : Frame.ALL,
                choice.tolerance());
    }

    /** The whole pictures without edges, whose wrong pixels are counted. */
    Frame plain(VisibilityChoice choice) {
        VisibilityChoice shown = filling(choice);
        return new Frame(
                plain(shown, choice.visibility(), pictureWidth(choice)),
                second(choice).map(method -> plain(shown, method, pictureWidth(choice))),
                false,
                Frame.ALL,
                Optional.empty());
    }

    /** The pixel of a picture that is nearest to that one. */
    ChosenPixel nearest(VisibilityChoice choice, ChosenPixel pixel) {
        int x = Math.max(0, Math.min(pictureWidth(choice) - 1, pixel.x()));
        int y = Math.max(0, Math.min(height - 1, pixel.y()));
        return new ChosenPixel(pixel.second() && second(choice).isPresent(), x, y);
    }

    ChosenPixel middle(VisibilityChoice choice) {
        return new ChosenPixel(false, pictureWidth(choice) / 2, height / 2);
    }

    /** The events at a pixel; empty where the pictures do not have it. */
    Optional<PixelReport.PixelRequest> question(VisibilityChoice choice, ChosenPixel pixel) {
        boolean inside = pixel.x() < pictureWidth(choice) && pixel.y() < height;
        boolean there = !pixel.second() || second(choice).isPresent();
        if (!inside || !there) return Optional.empty();
        String method = pixel.second() ? choice.comparison() : choice.visibility();
        return Optional.of(
                new PixelReport.PixelRequest(request(choice, method), pixel.x(), pixel.y()));
    }
}
