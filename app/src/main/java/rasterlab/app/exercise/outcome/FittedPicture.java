package rasterlab.app.exercise.outcome;

import java.awt.Graphics2D;
import java.awt.Image;
import java.awt.Rectangle;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import javax.swing.ImageIcon;

/**
 * A picture that is no grid of pixels: shown whole, in its own shape, in the middle of its place.
 */
public record FittedPicture(BufferedImage picture) implements PaintedPicture {
    @Override
    public void paint(Graphics2D g, Rectangle part, Rectangle place) {
        Rectangle fitted = fitted(place);
        g.setRenderingHint(
                RenderingHints.KEY_INTERPOLATION, RenderingHints.VALUE_INTERPOLATION_BICUBIC);
        g.drawImage(
                inDots(g.getTransform().getScaleX(), fitted),
                fitted.x,
                fitted.y,
                fitted.width,
                fitted.height,
                null);
    }

    /** The largest rectangle of the picture's shape in that place. */
    public Rectangle fitted(Rectangle place) {
        double scale =
                Math.min(
                        (double) place.width / picture.getWidth(),
                        (double) place.height / picture.getHeight());
        int width = (int) Math.max(1, Math.round(scale * picture.getWidth()));
        int height = (int) Math.max(1, Math.round(scale * picture.getHeight()));
        return new Rectangle(
                place.x + (place.width - width) / 2,
                place.y + (place.height - height) / 2,
                width,
                height);
    }

    /** The picture averaged over each dot of a smaller one: thin lines would be lost else. */
    private Image inDots(double perUnit, Rectangle fitted) {
        int width = (int) Math.max(1, Math.round(perUnit * fitted.width));
        int height = (int) Math.max(1, Math.round(perUnit * fitted.height));
        if (width >= picture.getWidth()) return picture;
        Image averaged = picture.getScaledInstance(width, height, Image.SCALE_AREA_AVERAGING);
        // Its pixels are there at once only in an icon.
        return new ImageIcon(averaged).getImage();
    }
}
