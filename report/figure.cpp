#include "report/figure.h"

namespace report {
namespace {

    std::vector<Figure>& registry()
    {
        static std::vector<Figure> figures; // first use is before main
        return figures;
    }

}

Figure::Figure(std::string name_, std::string title_, Part part_, Draw draw_)
    : Figure(std::move(name_), std::move(title_), part_, draw_, {})
{
}

Figure::Figure(std::string name_, std::string title_, Draw draw_, std::vector<std::string> results_)
    : Figure(std::move(name_), std::move(title_), Part::Measurements, draw_, std::move(results_))
{
}

Figure::Figure(std::string name_, std::string title_, Part part_, Draw draw_, std::vector<std::string> results_)
    : name(std::move(name_))
    , section(name.substr(0, name.find('.')))
    , title(std::move(title_))
    , part(part_)
    , draw(draw_)
    , results(std::move(results_))
{
    registry().push_back(*this);
}

const std::vector<Figure>& Figure::all()
{
    return registry();
}

}
