package rasterlab.app.tour;

import java.util.ArrayList;
import java.util.List;
import rasterlab.app.language.Complaints;
import rasterlab.app.language.Texts;
import rasterlab.engine.pipeline.RenderRequest;
import rasterlab.engine.pipeline.Renderer;
import rasterlab.engine.raster.PictureDifference;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.scene.catalogue.Scenes;

/**
 * Every scene as it is shown first; two of them by every visibility method, each beside its
 * difference to the exact picture.
 */
final class ScenePictures implements TourPart {
    private static final List<String> SCENES = List.of("vase", "cyclic-overlap");
    private static final String SHADING = Renderer.shadings().get(0);
    private static final int WIDTH = 800;
    private static final int HEIGHT = 600;

    @Override
    public String key() {
        return "scenes";
    }

    @Override
    public void make(TourPage page) {
        gallery(page);
        for (String scene : SCENES) make(page, Scenes.named(scene));
    }

    private static void gallery(TourPage page) {
        page.heading(page.texts().text("scenes.all"));
        List<TourPage.CaptionedPicture> figures = new ArrayList<>();
        try (var renderer = new Renderer()) {
            for (Scene scene : Scenes.all()) {
                page.say(scene.name());
                var request = request(scene, Renderer.AUTO, Renderer.AUTO);
                String caption =
                        page.texts()
                                .text(
                                        "scenes.chosen",
                                        scene.name(),
                                        Renderer.visibility(request).chosen(),
                                        Renderer.shading(request).chosen());
                var picture = renderer.render(request, () -> false).image();
                figures.add(page.picture(scene.name(), picture, caption));
            }
        }
        page.smallGallery(figures);
    }

    private static void make(TourPage page, Scene scene) {
        page.heading(page.texts().text("scenes.scene", scene.name(), SHADING));
        var renderer = new Renderer();
        Raster exact = renderer.render(request(scene, Renderer.REFERENCE, SHADING), () -> false);
        List<List<String>> rows = new ArrayList<>();
        List<TourPage.CaptionedPicture> figures = new ArrayList<>();
        for (String visibility : Renderer.visibilities()) {
            page.say(scene.name() + ": " + visibility);
            try {
                rows.add(byMethod(page, renderer, scene, visibility, exact, figures));
            } catch (IllegalArgumentException refusal) {
                rows.add(
                        List.of(
                                visibility,
                                Complaints.translated(
                                        page.texts().language(), refusal.getMessage())));
            }
        }
        page.table(page.texts().text("scenes.heads"), rows);
        page.smallGallery(figures);
        renderer.close();
    }

    private static List<String> byMethod(
            TourPage page,
            Renderer renderer,
            Scene scene,
            String visibility,
            Raster exact,
            List<TourPage.CaptionedPicture> figures) {
        long start = System.nanoTime();
        Raster picture = renderer.render(request(scene, visibility, SHADING), () -> false);
        double milliseconds = (System.nanoTime() - start) / 1e6;
        PictureDifference difference = PictureDifference.of(exact, picture);
        String name = scene.name() + "-" + visibility;
        figures.add(page.picture(name, picture.image(), scene.name() + ", " + visibility));
        figures.add(differenceFigure(page, name, difference));
        return row(page.texts(), visibility, difference, milliseconds);
    }

    private static RenderRequest request(Scene scene, String visibility, String shading) {
        return new RenderRequest(
                scene,
                visibility,
                shading,
                Renderer.projections().get(0),
                scene.defaultCamera(),
                WIDTH,
                HEIGHT);
    }

    private static List<String> row(
            Texts texts, String visibility, PictureDifference difference, double milliseconds) {
        return List.of(
                visibility,
                String.valueOf(difference.wrongPixels()),
                String.format(texts.locale(), "%.4f\u00a0%%", 100 * difference.share()),
                String.valueOf(difference.largestLevelDifference()),
                String.format(texts.locale(), "%.1f", milliseconds));
    }

    private static TourPage.CaptionedPicture differenceFigure(
            TourPage page, String name, PictureDifference difference) {
        String caption = page.texts().text("scenes.difference", difference.wrongPixels());
        return page.picture(name + "-difference", difference.mask().image(), caption);
    }
}
