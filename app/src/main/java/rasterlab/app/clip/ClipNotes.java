package rasterlab.app.clip;

import java.util.List;
import rasterlab.app.canvas.method.OwnWords;
import rasterlab.app.clip.outcome.Clipping;
import rasterlab.app.clip.outcome.SegmentClipping;
import rasterlab.app.clip.scene.ClipPoint;
import rasterlab.app.clip.scene.ClipScene;
import rasterlab.app.clip.scene.PolygonClipScene;
import rasterlab.app.clip.scene.SegmentScene;
import rasterlab.app.clip.scene.VolumeScene;
import rasterlab.app.language.Texts;
import rasterlab.engine.clip.segment.SegmentClipTopic;

/** One sentence over a stage where the picture alone would mislead. */
final class ClipNotes {
    private ClipNotes() {}

    /** "" where there is nothing to say. */
    static String about(ClipScene scene, Clipping clipping, Texts texts) {
        String method = OwnWords.called(clipping.method(), texts.language());
        return switch (clipping.ending()) {
            case ENDLESS -> texts.text("note.endless", method, SegmentClipTopic.MOST_STEPS);
            case REFUSED ->
                    OwnWords.refusal(clipping.method(), clipping.message(), texts.language())
                            .orElseGet(
                                    () -> texts.text("note.refused", method, reason(scene, texts)));
            case CRASHED -> texts.text("note.crashed", method, clipping.message());
            case ENDED -> ended(scene, clipping, texts);
        };
    }

    private static String ended(ClipScene scene, Clipping clipping, Texts texts) {
        String method = OwnWords.called(clipping.method(), texts.language());
        boolean pieces = scene instanceof PolygonClipScene;
        if (pieces && clipping.deviation().missing() > 0)
            return texts.text(
                    "note.bridges", method, clipping.parts().size(), clipping.deviation().of());
        if (!clipping.parts().isEmpty()) return "";
        return texts.text(clipping.isRight() ? "note.nothing" : "note.lost", method);
    }

    /** Why a method refuses the scene, in the window's language. */
    static String reason(ClipScene scene, Texts texts) {
        if (!isFinite(scene)) return texts.text("refusal.finite");
        if (scene instanceof SegmentScene segments && !segments.window().upright())
            return texts.text(
                    segments.method().equals("cyrus-beck") ? "refusal.window" : "refusal.upright");
        if (scene instanceof PolygonClipScene polygon) return texts.text(polygonReason(polygon));
        return texts.text("refusal.other");
    }

    private static String polygonReason(PolygonClipScene scene) {
        if (!SegmentClipping.isConvex(scene.window().xy())) return "refusal.window";
        return scene.subject().size() < 3 ? "refusal.corners" : "refusal.simple";
    }

    private static boolean isFinite(ClipScene scene) {
        if (scene instanceof SegmentScene plane)
            return plane.segments().stream().allMatch(s -> s.a().isFinite() && s.b().isFinite());
        if (scene instanceof VolumeScene space)
            return space.segments().stream().allMatch(s -> s.a().isFinite() && s.b().isFinite());
        return List.copyOf(((PolygonClipScene) scene).subject()).stream()
                .allMatch(ClipPoint::isFinite);
    }
}
