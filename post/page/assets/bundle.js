// SPDX-License-Identifier: BSD-3-Clause
// What of Apache ECharts is taken into echarts.min.js; README.md beside it says how it is made.
import { init, connect, getInstanceByDom, use, version } from "echarts/core";
import { BarChart, CustomChart, HeatmapChart, LineChart, ScatterChart } from "echarts/charts";
import { AriaComponent, AxisPointerComponent, DataZoomComponent, GridComponent, LegendComponent, LegendScrollComponent,
  MarkAreaComponent, MarkLineComponent, TitleComponent, TooltipComponent, VisualMapComponent } from "echarts/components";
import { CanvasRenderer, SVGRenderer } from "echarts/renderers";
use([BarChart, CustomChart, HeatmapChart, LineChart, ScatterChart, AriaComponent, AxisPointerComponent, DataZoomComponent,
  GridComponent, LegendComponent, LegendScrollComponent, MarkAreaComponent, MarkLineComponent, TitleComponent,
  TooltipComponent, VisualMapComponent, CanvasRenderer, SVGRenderer]);
window.echarts = { init, connect, getInstanceByDom, version };
