package rasterlab.app.study.front;

import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import rasterlab.app.chart.ChartLook;

/** A chart that can be drawn in any size. */
public interface StudyPicture {
    /** Draws it from the upper left corner, on a ground that is there. */
    void paint(Graphics2D graphics, double width, double height);

    /** The chart as a picture of the usual size. */
    default BufferedImage image(ChartLook paper) {
        return paper.image(graphics -> paint(graphics, ChartLook.WIDTH, ChartLook.HEIGHT));
    }

    /** The chart as an SVG document. */
    default byte[] svg(ChartLook paper) {
        return paper.svg(graphics -> paint(graphics, ChartLook.WIDTH, ChartLook.HEIGHT));
    }
}
