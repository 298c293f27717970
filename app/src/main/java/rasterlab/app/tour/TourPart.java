package rasterlab.app.tour;

/** One section of the tour's page. */
interface TourPart {
    /** Key of the section's title and introduction in the tour's texts; also its anchor. */
    String key();

    /**
     * Makes the section. What it throws is shown in the section's place, and the other parts are
     * still made.
     *
     * @param page receives the section's tables and pictures
     */
    void make(TourPage page) throws Exception;
}
