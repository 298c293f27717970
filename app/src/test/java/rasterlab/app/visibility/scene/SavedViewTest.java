package rasterlab.app.visibility.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.UnaryOperator;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import rasterlab.app.outcome.Complaint;
import rasterlab.app.outcome.PictureFile;
import rasterlab.engine.light.LightTerm;
import rasterlab.engine.pipeline.Cull;
import rasterlab.engine.pipeline.Stereo;
import rasterlab.engine.pipeline.paint.Sides;
import rasterlab.engine.pipeline.paint.TextureMode;
import rasterlab.engine.pipeline.wire.HiddenLines;
import rasterlab.engine.texture.TextureEnvironment.Mode;
import rasterlab.engine.texture.Wrap;
import rasterlab.engine.transform.SphericalView;
import rasterlab.engine.visibility.ClipPlane;

/** Saves views of the lab of hidden surfaces and opens them again. */
class SavedViewTest {
    @TempDir Path folder;

    /** A choice with nothing as it usually is. */
    private static VisibilityChoice all() {
        LookChoice look =
                LookChoice.USUAL
                        .withTexture(TextureMode.NEAREST)
                        .withWrap(Optional.of(Wrap.MIRRORED))
                        .withEnvironment(Optional.of(Mode.REPLACE))
                        .withTerms(Set.of(LightTerm.AMBIENT, LightTerm.DIFFUSE))
                        .withSides(Sides.ONE)
                        .withCull(Cull.FRONT)
                        .withHidden(HiddenLines.DASHED)
                        .withCrease(17)
                        .withCue(0.35)
                        .withStereo(Optional.of(Stereo.StereoMode.ANAGLYPH))
                        .withEyes(0.07)
                        .withNear(0.83)
                        .withFar(1.37)
                        .withClipPlanes(List.of(new ClipPlane(0.3, -1, 0.2, 14.9)));
        return VisibilityChoice.first()
                .withScene("textured-quad")
                .withCamera(new SphericalView(0.3, 1.1, 517.3))
                .withZoom(1.7)
                .withVisibility("painter")
                .withShading("flat")
                .withProjection("perspective")
                .withEdges(true)
                .with(look);
    }

    @Test
    @DisplayName("a choice is lost between saving and opening")
    void opensWhatWasSaved() {
        VisibilityChoice saved = all();
        VisibilityChoice opened = throughAFile(saved, VisibilityChoice.first());
        assertEquals(saved.plain(80, 60).look(), opened.plain(80, 60).look());
        assertEquals(saved.plain(80, 60).depth(), opened.plain(80, 60).depth());
        assertEquals(saved.look().change(), opened.look().change());
        assertEquals(saved.look().hidden(), opened.look().hidden());
        assertEquals(saved.look().crease(), opened.look().crease());
        assertEquals(saved.camera(), opened.camera());
        assertEquals(saved.zoom(), opened.zoom());
        assertEquals(saved.projection(), opened.projection());
        assertEquals(saved.edges(), opened.edges());
    }

    @Test
    @DisplayName("what was chosen before a file is opened stays where the file says it is usual")
    void opensAUsualViewOverAnUnusualOne() {
        VisibilityChoice usual = VisibilityChoice.first();
        VisibilityChoice opened = throughAFile(usual, all());
        assertEquals(usual, opened);
        Path bare = folder.resolve("bare.scene.json");
        VisibilityChoice plain =
                opened(write(bare, "{\"version\": 1, \"scene\": \"cube\"}"), all());
        assertEquals(LookChoice.USUAL, plain.look());
        assertEquals("painter", plain.visibility());
    }

    @Test
    @DisplayName("the picture on the faces is lost, or found in another folder")
    void keepsThePictureBesideTheFile() throws IOException {
        Path picture = folder.resolve("wood.png");
        var image = new BufferedImage(2, 2, BufferedImage.TYPE_INT_RGB);
        image.setRGB(0, 0, 0xFF8800);
        ImageIO.write(image, "png", picture.toFile());
        VisibilityChoice sphere = VisibilityChoice.first().withScene("sphere");
        SceneChoice covered = sphere.shown().covered(picture, PictureFile.texture(picture));
        VisibilityChoice saved = sphere.with(covered, sphere.camera());
        VisibilityChoice opened = throughAFile(saved, VisibilityChoice.first());
        assertEquals(picture.toRealPath(), opened.shown().image().orElseThrow().toRealPath());
        assertEquals("sphere", opened.scene());
        Path other = Files.createDirectory(folder.resolve("other")).resolve("one.scene.json");
        String problem =
                assertThrows(Complaint.class, () -> SceneFiles.save(other, saved)).getMessage();
        assertEquals(
                other
                        + ": the picture on the faces, "
                        + picture
                        + ", lies in another folder; save the scene beside it",
                problem);
    }

    private VisibilityChoice throughAFile(VisibilityChoice saved, VisibilityChoice before) {
        Path file = folder.resolve("one.scene.json");
        SceneFiles.save(file, saved);
        return opened(file, before);
    }

    private static VisibilityChoice opened(Path file, VisibilityChoice before) {
        SceneFiles.SceneAnswer answer = SceneFiles.read(file);
        assertTrue(answer.problem().isEmpty(), answer.problem());
        UnaryOperator<VisibilityChoice> change = answer.change();
        return change.apply(before);
    }

    private static Path write(Path file, String text) {
        try {
            return Files.writeString(file, text);
        } catch (IOException e) {
            throw new AssertionError(e);
        }
    }
}
