package rasterlab.app.tour;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import rasterlab.engine.pipeline.RenderRequest;
import rasterlab.engine.pipeline.Renderer;
import rasterlab.engine.raster.PictureDifference;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.scene.catalogue.Scenes;

/** Two scenes by every visibility method, each beside its difference to the exact picture. */
final class ScenePictures implements TourPart {
    private static final List<String> SCENES = List.of("vase", "house");
    private static final String SHADING = Renderer.shadings().get(0);
    private static final int WIDTH = 800;
    private static final int HEIGHT = 600;

    @Override
    public String key() {
        return "scenes";
    }

    @Override
    public void make(TourPage page) {
        for (String scene : SCENES) make(page, Scenes.named(scene));
    }

    private static void make(TourPage page, Scene scene) {
        page.heading(page.texts().text("scenes.scene", scene.name(), SHADING));
        var renderer = new Renderer();
        Raster exact = renderer.render(request(scene, Renderer.REFERENCE), () -> false);
        List<List<String>> rows = new ArrayList<>();
        List<TourPage.Figure> figures = new ArrayList<>();
        for (String visibility : Renderer.visibilities()) {
            page.say(scene.name() + ": " + visibility);
            long start = System.nanoTime();
            Raster picture = renderer.render(request(scene, visibility), () -> false);
            double milliseconds = (System.nanoTime() - start) / 1e6;
            PictureDifference difference = PictureDifference.of(exact, picture);
            rows.add(row(visibility, difference, milliseconds));
            String name = scene.name() + "-" + visibility;
            figures.add(page.picture(name, picture.image(), scene.name() + ", " + visibility));
            if (!visibility.equals(Renderer.REFERENCE))
                figures.add(differenceFigure(page, name, difference));
        }
        page.table(page.texts().text("scenes.heads"), rows);
        page.smallGallery(figures);
    }

    private static RenderRequest request(Scene scene, String visibility) {
        return new RenderRequest(
                scene,
                visibility,
                SHADING,
                Renderer.projections().get(0),
                scene.defaultCamera(),
                WIDTH,
                HEIGHT);
    }

    private static List<String> row(
            String visibility, PictureDifference difference, double milliseconds) {
        return List.of(
                visibility,
                String.valueOf(difference.wrongPixels()),
                String.format(Locale.ROOT, "%.4f %%", 100 * difference.share()),
                String.valueOf(difference.largestLevelDifference()),
                String.format(Locale.ROOT, "%.1f", milliseconds));
    }

    private static TourPage.Figure differenceFigure(
            TourPage page, String name, PictureDifference difference) {
        String caption = page.texts().text("scenes.difference", difference.wrongPixels());
        return page.picture(name + "-difference", difference.mask().image(), caption);
    }
}
